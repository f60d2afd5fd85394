# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""One node on an elastic layer whose top turns: schemes of first and second order for the slip, errors against cost."""
import csv
import io
import math

import numpy as np
import style
from points import StudyError, tool_point

plt = style.plt
PAGE = "accuracy.md"
SCHEMES = {"backward-euler": "backward Euler (the program's)", "trapezoidal": "mean of old and new normal",
           "midpoint": "implicit midpoint, and back to the cone", "bdf2": "two-step formula (BDF2)",
           "richardson-local": "a step against two halves, and back to the cone",
           "richardson": "two whole runs, extrapolated"}
PROGRAMS = {"turn": "turning slip", "reversals": "with reversals and sticking", "far": "a way of 10 μ"}
FRICTION = ("isotropic", "B", "C")
STEPS = (1, 2, 5, 10, 20, 40, 80, 160, 320)
MARKERS = "osD^v*"
DRIVES = 1e-12  # work of friction, relative to all that is dissipated


def extract(result, point):
    """Lists, one entry for each number of steps."""
    rows = list(csv.DictReader(io.StringIO(result.output)))
    if result.code != 0:
        raise StudyError(f"{point.command}\n{result.errors.strip()}")
    return {name: " ".join(row[name] for row in rows) for name in rows[0]}


def measured(context):
    schemes, programs, laws = SCHEMES, PROGRAMS, FRICTION
    if context.is_quick:
        schemes, programs, laws = ("backward-euler", "bdf2"), ("turn",), ("B",)
    points = [tool_point({"scheme": scheme, "program": program, "friction": law},
                         "layer", scheme, program, law, *STEPS)
              for program in programs for law in laws for scheme in schemes]
    return context.measure(points, extract, jobs=context.jobs, threads=1)


def chosen(rows, scheme, program, law):
    """{name: numbers} of one march, or nothing."""
    for row in rows:
        if (row["scheme"], row["program"], row["friction"]) == (scheme, program, law):
            return {name: np.array(row[name].split(), dtype=float)
                    for name in ("steps", "error", "solves", "driven", "dissipation_error")}
    return None


def order(found):
    """Between the last three numbers of steps."""
    return math.log(found["error"][-3] / found["error"][-1]) / math.log(found["steps"][-1] / found["steps"][-3])


def draw(ax, rows, program, law):
    for scheme, marker, colour in zip(SCHEMES, MARKERS, style.COLOURS):
        if (found := chosen(rows, scheme, program, law)) is None:
            continue
        ax.loglog(found["solves"], 100 * found["error"], marker + "-", lw=1, color=colour, label=SCHEMES[scheme])
        drives = found["driven"] > DRIVES
        ax.loglog(found["solves"][drives], 100 * found["error"][drives], "o", ms=10, mfc="none", color="black")
    ax.set_title(f"{PROGRAMS[program]}, case {law}")
    ax.set_xticks((1, 10, 100, 1000), ("1", "10", "100", "1000"))
    ax.set_yticks([10.0**power for power in range(-4, 3, 2)], ("0.0001", "0.01", "1", "100"))
    ax.minorticks_off()


def figures(rows):
    """Of the programs and laws of the table."""
    figure, axes = plt.subplots(2, 2, figsize=(style.WIDTH, 6), sharex=True, sharey=True)
    for line, program in zip(axes, PROGRAMS):
        for ax, law in zip(line, "BC"):
            draw(ax, rows, program, law)
        line[0].set_ylabel("largest error of the traction (%)")
    for ax in axes[-1]:
        ax.set_xlabel("one-node solutions")
    axes[0, 0].plot([], [], "o", ms=10, mfc="none", color="black", label="friction drives in some step")
    style.legend_below(figure, *axes[0, 0].get_legend_handles_labels(), 2)
    style.headline(figure, "Schemes of second order gain much only with small steps")
    return {"slip_integration": figure}


def tables(rows):
    lines = ["| scheme | turning, B: 10 steps, order | turning, C | with reversals, B | with reversals, C | "
             "friction drives, at most |", "|---|---|---|---|---|---|"]
    for scheme, label in SCHEMES.items():
        cells = []
        for program in ("turn", "reversals"):
            for law in "BC":
                found = chosen(rows, scheme, program, law)
                cells.append(f"{100 * found['error'][STEPS.index(10)]:.2g} %, {order(found):.2f}" if found else "–")
        driven = [float(share) for row in rows if row["scheme"] == scheme for share in row["driven"].split()]
        worst = max(driven, default=0)
        lines.append(f"| {label} | {' | '.join(cells)} | {f'{100 * worst:.2g} %' if worst > DRIVES else 'never'} |")
    return {"slip_integration": "\n".join(lines) + "\n"}
