# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""V-cycles and memory of an elastic solution, degrees 1 to 3, even and halved cells, from 11 000 unknowns on.

--large adds meshes of up to 4.8 million unknowns (8 GB)."""
import csv

import matplotlib.pyplot as plt

import style
from points import StudyError, tool_point

PAGE = "performance.md"
CUBES = {"Mesh/Model": "quarter", "Mesh/Core cells": 2, "Mesh/Rings": 1, "Mesh/Core ratio": 0.6, "Mesh/Layers": 2}
PRESSED = {"Load program/Legs": "0 0 -0.1 : 1", "Load program/Cycles": 1, "Contact solver/Tolerance": 1e-4}
EVEN, HALVED = "all halved", "some halved"
# Degree, refinements and rounds of Mesh/Adaptive; the first is the base of the memory.
BASE = (2, 0, 0)
SIZES = [(1, 3, 0), (1, 4, 0), (1, 5, 0), (2, 2, 0), (2, 3, 0), (2, 4, 0), (3, 2, 0), (3, 3, 0), (1, 2, 5), (2, 1, 5), (3, 1, 4)]
LARGE = [(1, 6, 0), (2, 5, 0), (3, 4, 0), (3, 1, 6)]


def point(degree, refinements, rounds):
    settings = {**CUBES, "Mesh/Degree": degree, "Mesh/Refinements": refinements}
    if rounds:
        settings |= {**PRESSED, "Mesh/Adaptive": rounds}
    words = [word for entry, value in settings.items() for word in ("--set", f"{entry}={value}")]
    return tool_point({"degree": degree, "refinements": refinements, "rounds": rounds}, "elastic", "prm/paper/case_b.prm", *words)


def extract(result, _point):
    if result.code:
        raise StudyError(result.errors.strip())
    return next(csv.DictReader(result.output.splitlines()))


def measured(context):
    sizes = SIZES[:1] if context.is_quick else SIZES + (LARGE if context.is_large else [])
    return context.measure([point(*size) for size in [BASE, *sizes]], extract, threads=1)


def bytes_a_dof(row, base):
    """Above the program with its smallest mesh."""
    return (float(row["peak_bytes"]) - float(base["peak_bytes"])) / int(row["dofs"])


def series(rows):
    """{(degree, cells): rows}, by size."""
    of = {}
    for row in sorted(rows[1:], key=lambda row: (int(row["rounds"]) > 0, int(row["degree"]), int(row["dofs"]))):
        of.setdefault((row["degree"], HALVED if int(row["rounds"]) else EVEN), []).append(row)
    return of


def figures(rows):
    figure, (counts, memory) = plt.subplots(1, 2, figsize=(style.WIDTH, 3.4))
    for colour, ((degree, cells), own) in zip(style.COLOURS, series(rows).items()):
        dofs = [int(row["dofs"]) for row in own]
        looks = {"marker": "o" if cells == EVEN else "s", "linestyle": "-" if cells == EVEN else "--", "color": colour,
                 "label": f"degree {degree}, {cells}"}
        counts.plot(dofs, [int(row["iterations"]) for row in own], **looks)
        memory.plot(dofs, [bytes_a_dof(row, rows[0]) for row in own], **looks)
    counts.set(title="V-cycles for eight digits", ylim=(0, 9.5))
    memory.set(title="bytes per degree of freedom", yscale="log")
    for axes in (counts, memory):
        axes.set(xlabel="degrees of freedom", xscale="log")
        axes.minorticks_off()
        axes.set_xticks((1e4, 1e5, 1e6), ("10 000", "100 000", "1 million"))
    style.plain_ticks(memory.yaxis, (200, 500, 1000, 2000, 5000))
    style.legend_below(figure, *counts.get_legend_handles_labels(), 3)
    style.headline(figure, "V-cycles hardly grow with the mesh; some halved cells take more memory")
    return {"elastic": figure}


def tables(rows):
    text = ("| degree | cells | degrees of freedom | contact nodes | V-cycles | bytes a degree of freedom |\n" +
            "|--:|---" + "|--:" * 4 + "|\n")
    for (degree, cells), own in series(rows).items():
        for row in own:
            text += (f"| {degree} | {cells} | {int(row['dofs']):,} | {row['contact_nodes']} | {row['iterations']} | "
                     f"{bytes_a_dof(row, rows[0]):.0f} |\n").replace(",", " ")
    return {"elastic": text}
