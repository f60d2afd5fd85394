# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Cells halved where the first cycle asks for it, beside graded rings: errors of four quantities against time.

One cycle of cases A, B and C. Adaptive meshes begin with even cells, or with the rings of a resolution. Slip, force and energy
are compared with the limit of even cells of degree 3 over their rounds, the stick area with the last of these, which have the
smallest cells along its border. --large adds meshes of up to 3.3 million unknowns (14 GB, four hours)."""
import matplotlib.pyplot as plt
import style
from one_cycle import FINEST
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "accuracy.md"
PROGRAM = {"Load program/Cycles": 1, "Output/Volume fields": 0, "Output/Contact fields": 0}
EVEN = {"Mesh/Core cells": 2, "Mesh/Rings": 1, "Mesh/Core ratio": 0.6, "Mesh/Layers": 2, "Mesh/Refinements": 1}
MORE = EVEN | {"Mesh/Degree": 3, "Mesh/Rings": 2, "Mesh/Core ratio": 0.5}
COARSE = {"Mesh/Degree": 3, "Mesh/Core cells": 4, "Mesh/Rings": 3, "Mesh/Core ratio": 0.6, "Mesh/Rim grading": 0.4,
          "Mesh/Layers": 6, "Mesh/Layer grading": 0.36}
GRADED, EVEN_2, EVEN_3, BOTH = "graded", "even, adaptive, degree 2", "even, adaptive, degree 3", "graded, adaptive"
MORE_3, MORE_ROUNDS = "more even, adaptive, degree 3", "2 rings, 8 rounds"
SERIES = {
    GRADED: {name: {"Mesh/Resolution": name} for name in ("coarse", "medium", "fine")} |
            {"14 core cells": dict(entry.split("=") for entry in FINEST)},
    EVEN_2: {f"{n} rounds": {**EVEN, "Mesh/Adaptive": n} for n in (1, 2, 3, 4, 5)},
    EVEN_3: {f"{n} rounds": {**EVEN, "Mesh/Degree": 3, "Mesh/Adaptive": n} for n in (1, 2, 3, 4)},
    BOTH: {f"coarse, {n} rounds": {**COARSE, "Mesh/Adaptive": n} for n in (1, 2, 3)},
    MORE_3: {},  # large ones alone
}
LARGE = {
    GRADED: {"18 core cells": SERIES[GRADED]["14 core cells"] | {"Mesh/Core cells": 18, "Mesh/Rings": 10, "Mesh/Layers": 18}},
    EVEN_3: {f"{n} rounds": {**EVEN, "Mesh/Degree": 3, "Mesh/Adaptive": n} for n in (5, 6, 7, 8)},
    MORE_3: {MORE_ROUNDS: {**MORE, "Mesh/Adaptive": 8}},
}
LEFT_OUT = {("b", "8 rounds"), ("c", "8 rounds"), ("c", MORE_ROUNDS)}  # they take long
QUANTITIES = {"largest_slip": "largest slip", "force": "total force", "dissipation": "dissipated energy",
              "stick_area": "stick area"}
QUICK = {GRADED: ("coarse",), EVEN_3: ("1 rounds",)}


def measures(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run = RunFolder(result.folder)
    summary, history = run.summary, run.history
    peak = list(history["uz"]).index(min(history["uz"]))
    return {"contact_nodes": summary["model"]["contact_nodes"], "unknowns": summary["model"]["free_dofs"],
            "v_cycles": summary["contact_solver"].get("v_cycles", 0), "cpu_seconds": f"{result.cpu_seconds:.3f}",
            "gigabytes": f"{result.gigabytes:.3f}", "largest_slip": max(history["max_slip"]),
            "force": history["force_z"][peak], "dissipation": history["total_dissipation"][-1],
            "stick_area": history["stick_area"][peak]}


def measured(context):
    points = []
    for case in ("b",) if context.is_quick else ("a", "b", "c"):
        for series, meshes in SERIES.items():
            for mesh, settings in (meshes | (LARGE.get(series, {}) if context.is_large else {})).items():
                if (case, mesh) not in LEFT_OUT and (not context.is_quick or mesh in QUICK.get(series, ())):
                    points.append(program_point({"case": case, "series": series, "mesh": mesh}, f"paper/case_{case}.prm",
                                                {**PROGRAM, "Mesh/Model": "quarter", **settings}))
    return context.measure(points, measures, threads=1)


def limit(values):
    """Of a sequence whose last steps shrink as those of a geometric series (Aitken, 1926); else its last value."""
    if len(values) < 3:
        return values[-1]
    before, last = values[-2] - values[-3], values[-1] - values[-2]
    return values[-1] + last * last / (before - last) if abs(last) < abs(before) else values[-1]


def references(rows):
    """{case: {quantity: value}}: of even cells of degree 3, from round to round."""
    of = {}
    for case in dict.fromkeys(row["case"] for row in rows):
        own = [row for row in rows if (row["case"], row["series"]) == (case, EVEN_3)]
        of[case] = {name: limit([float(row[name]) for row in own]) for name in QUANTITIES}
        of[case]["stick_area"] = float(own[-1]["stick_area"])
    return of


def errors_of(row, reference):
    return {name: 100 * (float(row[name]) / reference[name] - 1) for name in QUANTITIES}


def figures(rows):
    case, shown = "b", ("largest_slip", "dissipation", "stick_area")
    reference = references(rows)[case]
    figure, grid = plt.subplots(1, len(shown), figsize=(style.WIDTH, 3.4), sharey=True)
    for axes, name in zip(grid, shown):
        axes.set(xscale="log", yscale="log", title=QUANTITIES[name])
        for colour, series in zip(style.COLOURS, SERIES):
            own = [(float(row["cpu_seconds"]), abs(errors_of(row, reference)[name])) for row in rows
                   if (row["case"], row["series"]) == (case, series) and errors_of(row, reference)[name] != 0]  # the reference
            axes.plot([seconds for seconds, _ in own], [error for _, error in own], "o-", color=colour, label=series)
        axes.minorticks_off()
        style.plain_ticks(axes.xaxis, (1, 10, 100, 1000))
        style.plain_ticks(axes.yaxis, (0.001, 0.01, 0.1, 1))
    grid[0].set_ylabel("error (%)")
    grid[1].set_xlabel("processor time of search and run (s)")
    style.legend_below(figure, *grid[0].get_legend_handles_labels(), 3)
    style.headline(figure, "Case B: graded meshes are best for slip, adaptive ones for the stick area")
    return {"adaptive": figure}


def tables(rows):
    reference = references(rows)
    text = ("| case | mesh | | unknowns | contact nodes | V-cycles | seconds | GB | " + " | ".join(QUANTITIES.values()) +
            " |\n" + "|---" * (8 + len(QUANTITIES)) + "|\n")
    for row in rows:
        errors = errors_of(row, reference[row["case"]])
        text += (f"| {row['case'].upper()} | {row['series']} | {row['mesh']} | {row['unknowns']} | "
                 f"{row['contact_nodes']} | {row['v_cycles'] or ''} | {float(row['cpu_seconds']):.1f} | "
                 f"{float(row['gigabytes']):.2f} | " +
                 " | ".join(f"{error:+.3f} %" if name == "force" else f"{error:+.2f} %"
                            for name, error in errors.items()) + " |\n")
    return {"adaptive": text}
