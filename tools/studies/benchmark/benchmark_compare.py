# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Whole runs of two programs in turns, so that a busy minute of the machine hits both alike."""
import statistics
import tempfile

from benchmark_measure import PHASES, sample

SHOWN = 0.002  # s: parts that take less are noise


def samples_of_both(programs, cells, n_runs):
    """Figures of each program, run by run; the first one to run changes."""
    figures = [[], []]
    with tempfile.TemporaryDirectory() as folder:
        for run in range(n_runs):
            for which in (0, 1) if run % 2 == 0 else (1, 0):
                figures[which].append(sample(programs[which], cells, folder)[0])
    return figures


def ratio(ours, theirs):
    """Median of the ratios of the pairs, with the middle half of them."""
    ratios = [a / b for a, b in zip(ours, theirs)]
    if len(ratios) < 4:
        return f"{statistics.median(ratios):.3f}"
    low, _, high = statistics.quantiles(ratios, n=4)
    return f"{statistics.median(ratios):.3f} ({low:.3f} to {high:.3f})"


def rows(programs, cells, n_runs):
    ours, theirs = samples_of_both(programs, cells, n_runs)
    found = [("whole process", [row["process"] for row in ours], [row["process"] for row in theirs]),
             ("without start-up", *([row["process"] - row["start_up"] for row in side] for side in (ours, theirs))),
             *((phase, [row[phase] for row in ours], [row[phase] for row in theirs]) for phase in PHASES),
             ("memory", [row["gigabytes"] for row in ours], [row["gigabytes"] for row in theirs])]
    for name, our, their in found:
        if statistics.median(their) >= SHOWN:
            yield f"| {cells} | {name} | {statistics.median(our):.4g} | {statistics.median(their):.4g} | {ratio(our, their)} |"


def compare(program, against, sizes, n_runs):
    """Prints a table; seconds, and GB of memory."""
    print(f"benchmark: {program} against {against}, {n_runs} pairs of runs of case B on each mesh\n")
    print("| core cells | part | this | other | this / other, median of pairs (middle half) |\n|---|---|---|---|---|")
    for cells in sizes:
        for row in rows((program, against), cells, n_runs):
            print(row, flush=True)
