# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Draws the two pictures of the README from the tables of both runs.

Usage: plot.py FOLDER_OF_CYLINDER FOLDER_OF_BLOCK"""
import csv
import pathlib
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

FRICTION, SLIP_ELLIPSE, PEAK = (0.30, 0.15), (0.05, 0.20), 5


def table(file):
    with open(file, encoding="ascii") as lines:
        return list(csv.DictReader(lines))


def draw_cylinder(folder, mu=0.2):
    rows = [row for row in table(folder / "contact.csv") if int(row["step"]) == PEAK]
    radius, pressure, traction = (np.array([float(row[name]) for row in rows]) for name in ("x", "pressure", "traction_x"))
    stuck = max(radius[i] for i, row in enumerate(rows) if row["status"] == "stick")
    figure, axes = pyplot.subplots(figsize=(7, 4), constrained_layout=True)
    axes.axvspan(0, stuck, color="0.92")
    axes.plot(radius, pressure, "o-", ms=3, label="pressure")
    axes.plot(radius, -traction / mu, "s-", ms=3, label="friction traction / coefficient")
    axes.text(stuck / 2, 400, "sticks", ha="center")
    axes.text((stuck + radius[-1]) / 2, 400, "slips outward", ha="center")
    axes.set(xlabel="radius (mm)", ylabel="MPa", xlim=(0, radius[-1]), ylim=(0, None),
             title="Cylinder, pressed by 0.1 mm: where it slips, friction is at its limit")
    axes.legend(loc="upper left")
    figure.savefig("cylinder.png", dpi=110)


def draw_block(folder):
    rows = table(folder / "history.csv")
    path = np.array([[float(row[f"force_{axis}"]) / float(row["force_z"]) for axis in "xy"] for row in rows])
    angle = np.linspace(0, 2 * np.pi, 200)
    known = np.square(SLIP_ELLIPSE) / np.hypot(*(np.square(SLIP_ELLIPSE) / FRICTION))
    figure, axes = pyplot.subplots(figsize=(7, 4))
    axes.plot(FRICTION[0] * np.cos(angle), FRICTION[1] * np.sin(angle), color="0.5", label="friction ellipse")
    axes.plot(*path.T, "o-", ms=3, label="load steps")
    axes.plot(*np.transpose([known, -known]), "k+", ms=14, label="known answers for sliding")
    for sign in (1, -1):
        axes.annotate("", -sign * known + sign * np.array([0.05, 0.05]), -sign * known, arrowprops={"arrowstyle": "->"})
    axes.text(*(-known + [0.055, 0.045]), "slip")
    axes.text(*(known - [0.055, 0.05]), "slip", ha="right")
    axes.set(xlabel="$F_x / F_n$", ylabel="$F_y / F_n$", aspect="equal",
             title="Block: friction does not point against slip")
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))
    figure.savefig("block.png", dpi=110, bbox_inches="tight")


draw_cylinder(pathlib.Path(sys.argv[1]))
draw_block(pathlib.Path(sys.argv[2]))
