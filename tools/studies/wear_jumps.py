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
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4), sharey=True)
    for axes, places in ((left, [100 * share for share in shares]), (right, depths)):
        for values, mark, name, colour in ((errors, "o-", "error", style.COLOURS[0]),
                                           (estimates, "s--", "its estimate, wear_error", style.COLOURS[1])):
            axes.plot(places, [abs(value) for value in values], mark, color=colour, label=name)
        axes.set(yscale="log", xscale="log" if axes is right else "linear", yticks=(0.5, 1, 2, 5))
        axes.yaxis.set_major_formatter("{x:g}")
        axes.yaxis.set_minor_formatter("")
    right.xaxis.set_major_formatter("{x:g}")
    right.xaxis.set_minor_formatter("")
    for place, error, depth in zip(shares, errors, depths):
        if depth <= 5:
            left.annotate(f"{depth:g} nm", (100 * place, abs(error)), xytext=(4, 4), textcoords="offset points", fontsize=8)
    left.set(xlabel="time (% of that without jumps)", ylabel="worn volume: error (%)")
    right.set_xlabel("largest depth of a jump (nm)")
    right.legend()
    return {"wear_jumps": figure}


def tables(rows):
    text = ("| largest depth of a jump (nm) | load steps | error of the worn volume | its estimate | time / without jumps |\n"
            "|--:|--:|--:|--:|--:|\n")
    for depth, steps, error, estimate, share in numbers_of(rows):
        text += f"| {depth:g} | {steps} | {error:+.2f} % | {estimate:+.2f} % | {share:.3f} |\n"
    return {"wear jumps": text + f"| no jumps | {rows[-1]['steps']} | | | 1 |\n"}
