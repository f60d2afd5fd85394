# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Cost of half-spaces on grids of 64 x 64 to 1024 x 1024 patches: a press and a loop of partial slip, orthotropic and not
associated. Newton's iterations do not grow with the grid, those of GMRES grow slowly, and time little faster than n log n."""
import math

import matplotlib.pyplot as plt
import numpy as np
import style
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "performance.md"
SIZES = (64, 128, 256, 512, 1024)
SCENE = {"Friction/Coefficients": "0.3, 0.2", "Friction/Slip potential": "1, 0.5", "Output/Contact fields": 0,
         "Load program/Legs": "Fx 20 Fy 11.547 : 5 ; Fx -20 Fy -11.547 : 10 ; Fx 20 Fy 11.547 : 5",
         "Output/Checkpoint": 100000}


def grid_point(n):
    return program_point({"side": n}, "verification/ball_on_plate.prm", {**SCENE, "Mesh/Cells": f"{n}, {n}"})


def figures_of_run(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run = RunFolder(result.folder)
    with open(result.folder / "timing.csv", encoding="utf-8") as file:
        steps = np.genfromtxt(file, delimiter=",", names=True)
    return {"nodes": run.summary["model"]["contact_nodes"], "steps": len(steps),
            "iterations_per_step": f"{np.mean(steps['iterations']):.3g}", "most_iterations": int(np.max(steps["iterations"])),
            "gmres_per_step": f"{np.mean(steps['gmres_iterations']):.3g}",
            "most_gmres": int(np.max(steps["gmres_iterations"])),
            "step_seconds": f"{np.mean(steps['seconds']):.4g}", "seconds": f"{result.seconds:.3f}",
            "cpu_seconds": f"{result.cpu_seconds:.3f}", "gigabytes": f"{result.gigabytes:.3f}"}


def measured(context):
    return context.measure([grid_point(n) for n in SIZES[:1 if context.is_quick else None]], figures_of_run)


def per_node(row):
    """Microseconds of a step by n log2 n."""
    n = float(row["nodes"])
    return 1e6 * float(row["step_seconds"]) / (n * math.log2(n))


def figures(rows):
    figure, (left, right) = plt.subplots(1, 2, figsize=(style.WIDTH, 3.4))
    nodes = [float(row["nodes"]) for row in rows]
    left.loglog(nodes, [float(row["step_seconds"]) for row in rows], "o-", color=style.COLOURS[0], label="measured")
    last = float(rows[-1]["step_seconds"]) / (nodes[-1] * math.log2(nodes[-1]))
    left.loglog(nodes, [last * n * math.log2(n) for n in nodes], "--", color="0.5", label="n log n")
    left.set(xlabel="contact nodes n", ylabel="seconds of a step")
    left.legend()
    for column, marker, colour, label in (("iterations_per_step", "o-", 1, "Newton's, mean"),
                                          ("most_iterations", "s--", 1, "Newton's, worst step"),
                                          ("gmres_per_step", "o-", 2, "of GMRES, mean"),
                                          ("most_gmres", "s--", 2, "of GMRES, worst step")):
        right.semilogx(nodes, [float(row[column]) for row in rows], marker, color=style.COLOURS[colour], label=label)
    right.set(xlabel="contact nodes n", ylabel="iterations of a step", ylim=(0, None))
    right.legend()
    style.headline(figure, "Newton's iterations do not grow with the grid, and those of GMRES slowly")
    return {"half_space": figure}


def tables(rows):
    text = "| patches | steps | Newton's iterations of a step | worst step | iterations of GMRES | worst step | seconds of a step | µs by n log₂ n | run (s) | GB |\n" + "|--:" * 10 + "|\n"
    for row in rows:
        text += (f"| {row['side']} × {row['side']} | {row['steps']} | {row['iterations_per_step']} | {row['most_iterations']} | "
                 f"{row['gmres_per_step']} | {row['most_gmres']} | "
                 f"{float(row['step_seconds']):.3g} | {per_node(row):.2f} | {float(row['seconds']):.1f} | "
                 f"{float(row['gigabytes']):.2f} |\n")
    return {"half space": text}
