# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Formulas for the projection onto the elliptic cone: nanoseconds a call against correct digits.

Points are 64 of each class and law, outside of the cone and its polar, where projecting is work; digits are those of
|error| / |point| against 50-digit arithmetic."""
import csv
import io

import numpy as np
import style
from points import StudyError, tool_point

plt = style.plt
PAGE = "accuracy.md"
FORMULAS = {  # name of the experiment: what it is
    "program": "Newton on ψ/‖r‖ in a bracket (the program's)",
    "newton-halves-at-root": "the same, but halves the bracket at the root",
    "newton-psi": "Newton on ψ in a bracket",
    "plain-newton-relative": "Newton on ψ/‖r‖, no bracket",
    "plain-newton-psi": "Newton on ψ, no bracket",
    "bisection": "bisection",
    "newton-relative-single": "Newton on ψ/‖r‖, single precision",
    "companion": "quartic, eigenvalues",
    "ferrari": "quartic, Ferrari",
    "circular": "closed form of the circle",
}
CLASSES = ("generic", "an axis", "no pressure", "near the cone", "near the polar")
LAWS = {"usual": "usual laws: µ from 0.1 to 0.9,\nratio of the axes up to 4",
        "wide": "wide laws: µ from 0.001 to 1000,\nratio of the axes up to 1000"}
PALETTE = (*style.COLOURS, "#7f3c8d", "#888888", "#a05a2c")
MARKERS = "osDv^P*Xd<"


def laws_of(formula, laws):
    return "circular" if formula == "circular" else laws


def extract(result, point):
    rows = list(csv.DictReader(io.StringIO(result.output)))
    if result.code != 0:
        raise StudyError(f"{point.command}\n{result.errors.strip()}")
    found = {"nanoseconds": f"{np.median([float(row['nanoseconds']) for row in rows]):.1f}",
             "median_digits": f"{np.median([float(row['median_digits']) for row in rows]):.2f}",
             "failures": sum(int(row["failures"]) for row in rows), "points": sum(int(row["points"]) for row in rows)}
    for name in CLASSES:  # the worst digits of all laws
        found[name] = f"{min(float(row['worst_digits']) for row in rows if row['class'] == name):.2f}"
    return found


def measured(context):
    points = [tool_point({"formula": formula, "laws": laws_of(formula, laws)}, "projection", formula,
                         laws_of(formula, laws))
              for formula in (("program", "ferrari") if context.is_quick else FORMULAS)
              for laws in (("usual",) if formula == "circular" or context.is_quick else LAWS)]
    return context.measure(points, extract, jobs=1)


def chosen(rows, formula, laws):
    """The row of that formula, or None."""
    return next((row for row in rows if row["formula"] == formula and row["laws"] == laws_of(formula, laws)), None)


def failure_share(row):
    return int(row["failures"]) / int(row["points"])


def worst_digits(row):
    """None where a point has no answer."""
    return 0 if failure_share(row) > 0 else min(float(row[name]) for name in CLASSES)


def figures(rows):
    figure, axes = plt.subplots(1, 2, figsize=(style.WIDTH, 4.6), sharey=True, sharex=True)
    for ax, (laws, title) in zip(axes, LAWS.items()):
        for number, (formula, label) in enumerate(FORMULAS.items()):
            if (row := chosen(rows, formula, laws)) is None:
                continue
            time, median, colour = float(row["nanoseconds"]), float(row["median_digits"]), PALETTE[number]
            ax.plot([time, time], [worst_digits(row), median], "-", color=colour, lw=1)
            ax.plot(time, median, MARKERS[number], color=colour, mfc="white", ms=6)
            ax.plot(time, worst_digits(row), MARKERS[number], color=colour, ms=7, label=label, ls="",
                    zorder=3 if number == 0 else 2)
        ax.set(xscale="log", title=title, xlabel="time of a call (ns, median)", ylim=(-1, 17), yticks=(0, 5, 10, 15))
        ax.minorticks_off()
        style.plain_ticks(ax.xaxis, (10, 100, 1000))
    axes[0].set_ylabel("correct digits\n(open: median, filled: worst point)")
    style.legend_below(figure, *axes[0].get_legend_handles_labels(), 2)
    style.headline(figure, "Only iterations in a bracket have 15 digits and an answer everywhere")
    return {"projection": figure}


def tables(rows):
    lines = ["| formula | laws | ns | median digits | worst digits: " + " | ".join(CLASSES) + " | no answer |",
             "|---|---|---|---|" + "---|" * (len(CLASSES) + 1)]
    for formula, label in FORMULAS.items():
        for laws in ("usual",) if formula == "circular" else LAWS:
            if row := chosen(rows, formula, laws):
                digits = " | ".join(f"{float(row[name]):.1f}" for name in CLASSES)
                lines.append(f"| {label} | {row['laws']} | {float(row['nanoseconds']):.0f} | "
                             f"{float(row['median_digits']):.1f} | {digits} | {100 * failure_share(row):.2g} % |")
    return {"projection": "\n".join(lines) + "\n"}
