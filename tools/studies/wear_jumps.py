# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Jumps over cycles that wear: error of the worn volume against time, over `Wear/Largest depth of a jump`.

The fretting sphere of prm/verification with trilinear elements, for 2000 cycles. The reference computes every one of them."""
import matplotlib.pyplot as plt
import style
from points import StudyError, program_point
from run_folder import RunFolder

PAGE = "accuracy.md"
# Eight core cells: the border of the stick zone lies within one ring of nodes, whose wear is the fastest.
SMALL = {"Mesh/Core cells": 8, "Mesh/Degree": 1, "Mesh/Layers": 6, "Material/Poisson ratio": 0.3,
         "Mesh/Volumetric quadrature": "full"}
CYCLES, REFERENCE = 2000, 0
DEPTHS = (1e-4, 2e-5, 1e-5, 5e-6, 2.5e-6, 1.25e-6, REFERENCE)  # mm
QUICK = (2e-5, 5e-6, REFERENCE)


def measures(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    run = RunFolder(result.folder)
    cycles = run.cycles
    return {"steps": len(run.history["step"]), "worn_volume": cycles["worn_volume"][-1],
            "wear_error": cycles["wear_error"][-1], "depth": cycles["max_wear_depth"][-1],
            "cpu_seconds": f"{result.cpu_seconds:.3f}"}


def measured(context):
    cycles = 100 if context.is_quick else CYCLES
    points = [program_point({"largest_jump": depth}, "verification/fretting_wear.prm",
                            {**SMALL, "Load program/Cycles": cycles, "Wear/Largest depth of a jump": f"{depth:g}"},
                            "--threads", "1")
              for depth in (QUICK if context.is_quick else DEPTHS)]
    return context.measure(points, measures, threads=1)


def numbers_of(rows):
    """[(largest jump in nm, steps, error in %, estimate in %, share of the reference's time)] of the jumps."""
    *jumps, reference = rows
    volume, seconds = float(reference["worn_volume"]), float(reference["cpu_seconds"])
    return [(1e6 * float(row["largest_jump"]), int(row["steps"]), 100 * (float(row["worn_volume"]) / volume - 1),
             100 * float(row["wear_error"]) / volume, float(row["cpu_seconds"]) / seconds) for row in jumps]


def figures(rows):
    depths, _, errors, estimates, shares = zip(*numbers_of(rows))
    figure, (left, right) = plt.subplots(1, 2, figsize=(style.WIDTH, 2.9))
    for values, mark, name, colour in ((errors, "o-", "error", style.COLOURS[0]),
                                       (estimates, "s--", "error that the run estimates", style.COLOURS[1])):
        left.plot(depths, [abs(value) for value in values], mark, color=colour, label=name)
    left.set(yscale="log", ylabel="error of the worn volume (%)")
    left.legend()
    style.plain_ticks(left.yaxis, (0.5, 1, 2, 5, 10))
    right.plot(depths, [100 * share for share in shares], "o-", color=style.COLOURS[0])
    right.set(ylim=(0, None), ylabel="time (% of that without jumps)")
    for axes in (left, right):
        axes.set(xscale="log", xlabel="largest depth of a jump (nm)")
        style.plain_ticks(axes.xaxis, (1, 2, 5, 10, 20, 50, 100))
    style.headline(figure, "Shallower jumps lower the error of the worn volume, and take longer")
    return {"wear_jumps": figure}


def tables(rows):
    text = ("| largest depth of a jump (nm) | load steps | error of the worn volume | its estimate | time / without jumps |\n"
            "|--:|--:|--:|--:|--:|\n")
    for depth, steps, error, estimate, share in numbers_of(rows):
        text += f"| {depth:g} | {steps} | {error:+.2f} % | {estimate:+.2f} % | {share:.3f} |\n"
    return {"wear jumps": text + f"| no jumps | {rows[-1]['steps']} | | | 1 |\n"}
