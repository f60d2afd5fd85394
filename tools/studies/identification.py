# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Friction and compliance that tools/identify finds from loops of 20 rigs whose friction is known, with 2 % noise."""
import json

import matplotlib.pyplot as plt
import numpy as np

import style
from points import Point, StudyError

PAGE = "identify.md"
N_RIGS = 20
PARAMETERS = {"mu_x": r"$\mu_x$", "mu_y": r"$\mu_y$", "slip_ratio": "$p_x/p_y$", "rig_compliance": "compliance of the rig"}


def outcome(result, point):
    if result.code != 0:
        raise StudyError(f"exit code {result.code}: {point.command}\n{result.errors}")
    return {name: "" if value is None else value for name, value in json.loads(result.output).items()}


def measured(context):
    rigs = range(1, (1 if context.is_quick else N_RIGS) + 1)
    points = [Point({"rig": rig}, ["tools/python", "numpy", "tools/studies/synthetic_rigs.py", str(rig), "--program", "build/orthocone"])
              for rig in rigs]
    return context.measure(points, outcome)


def numbers_of(rows, name):
    """(rigs, 3): estimate and both ends of the interval over the truth; nan where it is not told."""
    return np.array([[float(row[f"{name}_{part}"] or "nan") / float(row[name]) for part in ("found", "low", "high")] for row in rows])


def figures(rows):
    figure, panels = plt.subplots(2, 2, figsize=(style.WIDTH, 4.2), sharex=True)
    for axes, (name, label) in zip(panels.flat, PARAMETERS.items()):
        found, low, high = 100 * (numbers_of(rows, name).T - 1)
        rigs = [int(row["rig"]) for row in rows]
        is_inside = (low <= 0) & (high >= 0)
        for inside, colour in ((True, style.COLOURS[0]), (False, style.COLOURS[1])):
            own = is_inside == inside
            axes.errorbar(np.array(rigs)[own], found[own], [(found - low)[own], (high - found)[own]], fmt="o", color=colour, markersize=3,
                          linewidth=1)
        axes.axhline(0, color="0.3", linewidth=0.8)
        axes.set(ylabel="error (%)", title=label)
    for axes in panels[1]:
        axes.set(xlabel="rig", xticks=[1, 5, 10, 15, 20])
    style.headline(figure, "The truth lies within nearly all 95 % intervals")
    return {"identification": figure}


def tables(rows):
    text = ("| parameter | largest error | median half-width of the interval | truth within the interval |\n|---|--:|--:|--:|\n")
    for name in PARAMETERS:
        found, low, high = numbers_of(rows, name).T
        inside = np.sum((low <= 1) & (high >= 1))
        text += (f"| `{name}` | {100 * np.nanmax(np.abs(found - 1)):.2f} % | {100 * np.nanmedian(high - low) / 2:.2f} % | "
                 f"{inside} of {len(rows)} |\n")
    seconds = [float(row["seconds"]) for row in rows]
    return {"identification": text + f"\nA fit took {np.median(seconds):.0f} s, the longest {max(seconds):.0f} s.\n"}
