# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Thousands of random problems of one to eight nodes, strongly coupled: which method solves how many."""
import csv
import json

import matplotlib.pyplot as plt

import style
from points import StudyError, tool_point
from style import METHODS

PAGE = "stability.md"
NODES = (1, 2, 4, 8)
N_PROBLEMS = 2000
MOST_ITERATIONS = {"newton": 5000}  # the program's; of the others:
FEWER_ITERATIONS = 1000
VERDICTS = {"converged": "#0072b2", "slow": "#e69f00", "rounding": "#999999", "cycling": "#cc79a7", "diverged": "#000000"}


def extract(result, _point):
    if result.code:
        raise StudyError(result.errors.strip())
    rows = csv.DictReader(result.output.splitlines())
    return {"counts": json.dumps({f"{row['friction']} {row['verdict']}": int(row["problems"]) for row in rows})}


def measured(context):
    n = 50 if context.is_quick else N_PROBLEMS
    return context.measure([tool_point({"method": method, "nodes": nodes}, "small_problems", method, nodes, n,
                                       MOST_ITERATIONS.get(method, FEWER_ITERATIONS))
                            for method in METHODS for nodes in NODES], extract, jobs=context.jobs, threads=1)


def counts(row, kinds=("above", "below")):
    found = json.loads(row["counts"])
    return {verdict: sum(found.get(f"{kind} {verdict}", 0) for kind in kinds) for verdict in VERDICTS}


def figures(rows):
    figure, grid = plt.subplots(2, 2, figsize=(style.WIDTH, 4.4), sharex=True, sharey=True)
    grid[0, 0].invert_yaxis()
    found = [verdict for verdict in VERDICTS if any(counts(row)[verdict] for row in rows)]
    for axes, nodes in zip(grid.flat, NODES):
        own = {row["method"]: counts(row) for row in rows if int(row["nodes"]) == nodes}
        left = dict.fromkeys(own, 0.)
        for verdict in found:
            shares = {method: 100 * of[verdict] / sum(of.values()) for method, of in own.items()}
            axes.barh(list(shares), list(shares.values()), left=list(left.values()), color=VERDICTS[verdict], label=verdict)
            left = {method: left[method] + share for method, share in shares.items()}
        axes.grid(False)
        axes.set_title(f"{nodes} node{'s' if nodes > 1 else ''}")
    for axes in grid[-1]:
        axes.set(xlabel="share of the problems (%)", xticks=(0, 20, 40, 60, 80, 100), xlim=(0, 101))
    style.legend_below(figure, *grid[0, 0].get_legend_handles_labels(), len(found))
    style.headline(figure, "newton alone solves all of the random problems")
    return {"small_problems": figure}


def tables(rows):
    text = "| method | " + " | ".join(f"{n} node{'s' if n > 1 else ''}" for n in NODES) + " |\n" + "|---" * 5 + "|\n"
    for method in METHODS:
        cells = []
        for nodes in NODES:
            row = next(row for row in rows if row["method"] == method and int(row["nodes"]) == nodes)
            below, every = counts(row, ("below",)), counts(row)
            failed = sum(every.values()) - every["converged"]
            cells.append(f"{failed} of {sum(every.values())}, {sum(below.values()) - below['converged']} of {sum(below.values())}")
        text += f"| `{method}` | " + " | ".join(cells) + " |\n"
    return {"small problems": text}
