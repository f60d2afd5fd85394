# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Contact solvers: residual against time on easy, typical and hard steps, iterations against contact nodes."""
import csv

import matplotlib.pyplot as plt
import numpy as np

import style
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
    figure, grid = plt.subplots(1, len(titles), figsize=(style.WIDTH, 3.5), sharey=True, squeeze=False)
    for axes, title in zip(grid[0], titles):
        own = [row for row in rows if row["chart"] == title]
        for row in own:
            seconds = 1e3 * numbers(row, "trace_seconds")
            residuals = np.clip(numbers(row, "trace_residuals"), 1e-17, 1e3)
            axes.plot(np.maximum(seconds, 1e-2), residuals, color=METHOD_COLOURS[row["method"]], label=row["method"])
            axes.plot(max(seconds[-1], 1e-2), residuals[-1], "o" if row["verdict"] == "converged" else "x",
                      color=METHOD_COLOURS[row["method"]], markersize=5)
        axes.axhline(1e-10, color="grey", lw=0.8, ls=":")
        ease, _, step = title.partition(": ")
        axes.set(xscale="log", yscale="log", title=f"{ease}, {own[0]['contact_nodes']} nodes\n({step})")
        axes.minorticks_off()
        style.plain_ticks(axes.xaxis, (0.01, 1, 100))
        axes.xaxis.set_minor_locator(plt.FixedLocator((0.1, 10, 1000)))
    grid[0][0].set_ylabel("residual")
    grid[0][len(titles) // 2].set_xlabel("time in the step (ms)")
    style.legend_below(figure, *grid[0][0].get_legend_handles_labels(), 6)
    style.headline(figure, "newton solves every step, and needs the least time")
    return figure


def size_line(axes, rows, quantity, label, **looks):
    converged = [row for row in rows if row["verdict"] == "converged"]
    axes.plot([int(row["contact_nodes"]) for row in converged], [quantity(row) for row in converged], label=label, **looks)


def sizes(rows):
    cases = [case for case in METHODS_OF_SIZES if any(row["chart"] == f"sizes {case}" for row in rows)]
    figure, grid = plt.subplots(1, 2, figsize=(style.WIDTH, 3.6))
    for case, marker in zip(cases, ("o-", "^--")):
        for method in COMPARED:
            own = [row for row in rows if row["chart"] == f"sizes {case}" and row["method"] == method]
            if own:
                looks = {"color": METHOD_COLOURS[method], "marker": marker[0], "ls": marker[1:]}
                size_line(grid[0], own, lambda row: int(row["iterations"]), f"{method}, case {case}", **looks)
                size_line(grid[1], own, lambda row: 1e3 * float(row["seconds"]), f"{method}, case {case}", **looks)
    for axes, title, ticks in zip(grid, ("iterations in the step", "time in the step (ms)"),
                                  ((10, 100, 1000), (1, 10, 100, 1000, 10000))):
        axes.set(xscale="log", yscale="log", title=title, xlabel="contact nodes (quarter, degree 2)")
        axes.minorticks_off()
        style.plain_ticks(axes.xaxis, (100, 200, 500, 1000))
        style.plain_ticks(axes.yaxis, ticks)
    style.legend_below(figure, *grid[0].get_legend_handles_labels(), 3)
    style.headline(figure, "newton takes the fewest iterations, and they hardly grow with the mesh")
    return figure


def figures(rows):
    return {"solvers": traces(rows), "solver_sizes": sizes(rows)}


def table_of_steps(rows):
    text = "| step | " + " | ".join(f"`{method}`" for method in METHODS) + " |\n" + "|---" * (len(METHODS) + 1) + "|\n"
    for title in STEPS:
        own = {row["method"]: row for row in rows if row["chart"] == title}
        if own:
            text += f"| {title} | " + " | ".join(
                f"{own[method]['iterations']}, {1e3 * float(own[method]['seconds']):.0f} ms" if
                own[method]["verdict"] == "converged" else f"{own[method]['verdict']}" for method in METHODS) + " |\n"
    return text


def table_of_condensing(rows):
    """What an iteration of uzawa takes: a dense product, or a solution with the sparse factor."""
    text = "| contact nodes | condensed: a dense product | not condensed: a solution with the sparse factor |\n|--:|--:|--:|\n"
    times = {}
    for row in rows:
        if row["method"] == "uzawa" and row["chart"] in ("sizes B", "condensed"):
            milliseconds = 1e3 * float(row["seconds"]) / int(row["iterations"])
            times.setdefault(int(row["contact_nodes"]), {})[row["chart"]] = f"{milliseconds:.2g} ms"
    for nodes, of in times.items():
        text += f"| {nodes} | {of.get('sizes B', '')} | {of.get('condensed', '')} |\n"
    return text


def tables(rows):
    return {"solvers": table_of_steps(rows), "condensing": table_of_condensing(rows)}
