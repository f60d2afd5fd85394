# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Cost of an elastic half-space below a body, with a dense matrix beside a factorization and with a hierarchical one beside
multigrid, on the paper's cylinder with meshes whose cells are halved."""
import csv

import matplotlib.pyplot as plt
import style
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "performance.md"
SCENE = {"Load program/Preload": "0 0 -0.01 : 2", "Load program/Legs": "ux 0.004 : 3", "Load program/Cycles": 1,
         "Mesh/Core cells": 4, "Mesh/Rings": 2, "Mesh/Layers": 4, "Output/Contact fields": 0, "Output/Volume fields": 0}
COUNTERFACES = {"rigid": {"Obstacle/Kind": "rigid"},
                "half-space": {"Obstacle/Kind": "half-space", "Obstacle/Young modulus": 210000, "Obstacle/Poisson ratio": 0.3}}
CASES = (("condensed", "half-space", (0, 1, 2)), ("multigrid", "half-space", (0, 1, 2, 3)), ("multigrid", "rigid", (0, 1, 2, 3)))


def points(is_quick):
    for backend, counterface, all_refinements in CASES:
        for refinements in all_refinements[:1 if is_quick else None]:
            yield program_point({"refinements": refinements, "backend": backend, "counterface": counterface},
                                "paper/case_b.prm", {**SCENE, **COUNTERFACES[counterface], "Mesh/Backend": backend,
                                                     "Mesh/Refinements": refinements})


def figures_of_run(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run = RunFolder(result.folder)
    with open(result.folder / "history.csv", encoding="utf-8") as file:
        last = list(csv.DictReader(file))[-1]
    model = run.summary["model"]
    return {"dofs": model["dofs"], "nodes": model["contact_nodes"], "force_x": last["force_x"],
            "v_cycles": run.summary["contact_solver"].get("v_cycles", 0), "cpu_seconds": f"{result.cpu_seconds:.3f}",
            "seconds": f"{result.seconds:.3f}", "gigabytes": f"{result.gigabytes:.3f}"}


def measured(context):
    return context.measure(list(points(context.is_quick)), figures_of_run)


def of_case(rows, backend, counterface):
    return [row for row in rows if row["backend"] == backend and row["counterface"] == counterface]


def figures(rows):
    figure, axes = plt.subplots(1, 2, figsize=(style.WIDTH, 3.2))
    for axis, column, label in zip(axes, ("cpu_seconds", "gigabytes"), ("processor time (s)", "memory (GB)")):
        for colour, (backend, counterface, _) in enumerate(CASES):
            chosen = of_case(rows, backend, counterface)
            axis.loglog([float(row["nodes"]) for row in chosen], [float(row[column]) for row in chosen], "o-",
                        color=style.COLOURS[colour], label=f"{backend}, {counterface}")
        axis.set(xlabel="contact nodes", ylabel=label)
    axes[0].legend()
    style.headline(figure, "Multigrid takes a half-space where dense matrices grow too large")
    return {"half_space_multigrid": figure}


def tables(rows):
    text = ("| degrees of freedom | contact nodes | condensed (s) | GB | multigrid (s) | GB | V-cycles | on a rigid plane (s) | GB "
            "| V-cycles | difference of the force |\n" + "|--:" * 11 + "|\n")
    condensed, multigrid, rigid = (
        {row["refinements"]: row for row in of_case(rows, backend, counterface)} for backend, counterface, _ in CASES)
    for refinements, row in multigrid.items():
        dense, plane = condensed.get(refinements), rigid[refinements]
        text += f"| {int(row['dofs']):,} | {row['nodes']} | ".replace(",", " ")
        text += f"{float(dense['cpu_seconds']):.1f} | {float(dense['gigabytes']):.2f} | " if dense else "| | "
        for own in (row, plane):
            text += f"{float(own['cpu_seconds']):.1f} | {float(own['gigabytes']):.2f} | {own['v_cycles']} | "
        text += f"{abs(float(row['force_x']) / float(dense['force_x']) - 1):.0e} |\n" if dense else "|\n"
    return {"hierarchical half space": text}
