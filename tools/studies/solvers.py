# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Contact solvers: residual against time on easy, typical and hard steps, iterations against contact nodes."""
import csv

import matplotlib.pyplot as plt
import numpy as np

from points import StudyError, tool_point
from style import METHOD_COLOURS, METHODS

PAGE = "accuracy.md"
TOLERANCE = 1e-12  # lower than the default: the charts show where residuals end
MOST_ITERATIONS = 20000
GRADED = {"Mesh/Core cells": 4, "Mesh/Rings": 4, "Mesh/Layers": 6, "Mesh/Degree": 2, "Mesh/Core ratio": 0.6,
          "Mesh/Rim grading": 0.4, "Mesh/Layer grading": 0.5}
STEPS = {  # title: (file, step, settings)
    "easy: A, the peak at once": ("case_a.prm", 1, {"Mesh/Model": "quarter", "Load program/Legs": "0 0 -0.1 : 1 ; 0 0 0 : 10"}),
    "typical: B, third step up": ("case_b.prm", 8, {}),
    "hard: C, third step up, graded": ("case_c.prm", 8, GRADED),
}
SIZES = (4, 6, 8, 12, 16)  # core cells
COMPARED = ("newton", "gauss-seidel", "uzawa", "feng2006")
METHODS_OF_SIZES = {"B": COMPARED, "C": ("newton", "gauss-seidel")}
FINEST_OF_OTHERS = 12  # core cells; beyond, others than newton take minutes
FINEST_NOT_CONDENSED = 8
STORED = 80  # points of a trace that are kept


def trace_point(columns, file, step, settings, method, *options):
    words = []
    for entry, value in {"Contact solver/Tolerance": TOLERANCE, "Contact solver/Maximum iterations": MOST_ITERATIONS,
                         **settings}.items():
        words += ["--set", f"{entry}={value}"]
    return tool_point({**columns, "method": method}, "trace", f"prm/paper/{file}", *words, "--step", step, "--method",
                      method, *options)


def kept(n):
    """Places in a trace of n points, closer together at its beginning."""
    return np.unique(np.round(np.geomspace(1, n, STORED)).astype(int) - 1)


def figures_of_trace(result, _point):
    if result.code:
        raise StudyError(result.errors.strip())
    lines = list(csv.DictReader(result.output.splitlines()))
    last = lines[-1]
    return {"contact_nodes": last["contact_nodes"], "setup_seconds": last["setup_seconds"],
            "iterations": last["iterations"], "seconds": last["seconds"], "verdict": last["verdict"],
            "trace_seconds": " ".join(lines[i]["seconds"] for i in kept(len(lines))),
            "trace_residuals": " ".join(lines[i]["residual"] for i in kept(len(lines)))}


def measured(context):
    steps = {title: STEPS[title] for title in list(STEPS)[:1]} if context.is_quick else STEPS
    points = [trace_point({"chart": title, "cells": "", "condensed": 1}, *step, method)
              for title, step in steps.items() for method in METHODS]
    for cells in SIZES[:1] if context.is_quick else SIZES:
        mesh = {"Mesh/Core cells": cells, "Mesh/Layers": max(1, cells // 2), "Contact solver/Tolerance": 1e-10}
        for case, methods in METHODS_OF_SIZES.items():
            points += [trace_point({"chart": f"sizes {case}", "cells": cells, "condensed": 1},
                                   f"case_{case.lower()}.prm", 8, mesh, method)
                       for method in methods if method == "newton" or cells <= FINEST_OF_OTHERS]
        if cells <= FINEST_NOT_CONDENSED:
            points.append(trace_point({"chart": "condensed", "cells": cells, "condensed": 0}, "case_b.prm", 8, mesh,
                                      "uzawa", "--condensed", 0))
    return context.measure(points, figures_of_trace, jobs=1, threads=1)


def numbers(row, name):
    return np.array([float(value) for value in row[name].split()])


def traces(rows):
    titles = [title for title in STEPS if any(row["chart"] == title for row in rows)]
    figure, grid = plt.subplots(1, len(titles), figsize=(3.6 * len(titles), 3.4), sharey=True, squeeze=False)
    for axes, title in zip(grid[0], titles):
        for row in (row for row in rows if row["chart"] == title):
            seconds = 1e3 * numbers(row, "trace_seconds")
            residuals = np.clip(numbers(row, "trace_residuals"), 1e-17, 1e3)
            axes.loglog(np.maximum(seconds, 1e-2), residuals, color=METHOD_COLOURS[row["method"]], lw=1.3,
                        label=f"{row['method']}")
            axes.plot(max(seconds[-1], 1e-2), residuals[-1], "o" if row["verdict"] == "converged" else "x",
                      color=METHOD_COLOURS[row["method"]])
        axes.axhline(1e-10, color="grey", lw=0.8, ls=":")
        axes.set_title(f"{title}\n{[row for row in rows if row['chart'] == title][0]['contact_nodes']} contact nodes",
                       fontsize=9)
        axes.set_xlabel("milliseconds in the step")
    grid[0][0].set_ylabel("residual")
    grid[0][0].legend(fontsize=7, loc="lower left")
    return figure


def size_line(axes, rows, quantity, label, **style):
    converged = [row for row in rows if row["verdict"] == "converged"]
    axes.loglog([int(row["contact_nodes"]) for row in converged], [quantity(row) for row in converged], label=label,
                ms=4, **style)


def sizes(rows):
    cases = [case for case in METHODS_OF_SIZES if any(row["chart"] == f"sizes {case}" for row in rows)]
    figure, grid = plt.subplots(1, 3, figsize=(11, 3.4))
    for case, marker in zip(cases, ("o-", "^--")):
        for method in COMPARED:
            own = [row for row in rows if row["chart"] == f"sizes {case}" and row["method"] == method]
            if not own:
                continue
            style = {"color": METHOD_COLOURS[method], "marker": marker[0], "ls": marker[1:]}
            size_line(grid[0], own, lambda row: int(row["iterations"]), f"{method}, {case}", **style)
            size_line(grid[1], own, lambda row: float(row["seconds"]), f"{method}, {case}", **style)
    own = [row for row in rows if row["chart"] == "sizes B" and row["method"] == "uzawa"]
    size_line(grid[2], own, lambda row: float(row["seconds"]) / int(row["iterations"]), "condensed: dense product",
              color="#0072b2", marker="o")
    size_line(grid[2], [row for row in rows if row["chart"] == "condensed"],
              lambda row: float(row["seconds"]) / int(row["iterations"]), "not condensed: solution with the sparse factor",
              color="#d55e00", marker="s")
    for axes, label in zip(grid, ("iterations in the step", "seconds in the step", "seconds per iteration of uzawa")):
        axes.set_xlabel("contact nodes (quarter, Q2)")
        axes.set_ylabel(label)
    grid[1].legend(fontsize=6.5, loc="upper left")
    grid[2].legend(fontsize=7)
    for axes in grid:
        axes.set_xticks([100, 200, 500, 1000], ["100", "200", "500", "1000"])
        axes.set_xticks([], minor=True)
    return figure


def figures(rows):
    return {"solvers": traces(rows), "solver_sizes": sizes(rows)}


def tables(rows):
    text = "| step | " + " | ".join(f"`{method}`" for method in METHODS) + " |\n" + "|---" * (len(METHODS) + 1) + "|\n"
    for title in STEPS:
        own = {row["method"]: row for row in rows if row["chart"] == title}
        if own:
            text += f"| {title} | " + " | ".join(
                f"{own[method]['iterations']}, {1e3 * float(own[method]['seconds']):.0f} ms" if
                own[method]["verdict"] == "converged" else f"{own[method]['verdict']}" for method in METHODS) + " |\n"
    return {"solvers": text}
