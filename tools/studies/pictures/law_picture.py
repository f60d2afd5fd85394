# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The friction law of a node, as docs/theory.md has it: both ellipses, and the circle that they become. Started by
tools/study law."""
import argparse
import pathlib

import matplotlib.pyplot as plt
import numpy as np

import docs_page
from panels import BLUE, GREY, RED
from paths import ROOT

MU, P = np.array([0.3, 0.15]), np.array([0.05, 0.2])  # case C of the paper
ANGLES = np.radians((0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330))


def ring(axes):
    t = np.linspace(0, 2 * np.pi, 361)
    return axes[0] * np.cos(t), axes[1] * np.sin(t)


def arrow(ax, start, way, colour):
    ax.annotate("", start + way, start, arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 1.2, "shrinkA": 0,
                                               "shrinkB": 0})


def frame(ax, reach, title, x, y):
    ax.axhline(0, color=GREY, linewidth=0.6)
    ax.axvline(0, color=GREY, linewidth=0.6)
    ax.set(aspect="equal", xlim=(-reach, reach), ylim=(-reach, reach), title=title, xlabel=x, ylabel=y)


def ellipses(ax):
    """Forces on the friction ellipse, and the slip against each: the normal of the slip ellipse through the force."""
    frame(ax, 0.46, "per unit normal force", "along x", "along y")
    ax.plot(*ring(MU), color=BLUE, linewidth=1.5)
    ax.plot(*ring(P), color=RED, linestyle="--")
    for angle in ANGLES:
        force = MU * (np.cos(angle), np.sin(angle))
        slip = -force / P**2
        arrow(ax, force, 0.1 * slip / np.hypot(*slip), RED)
    arrow(ax, np.zeros(2), MU * (np.cos(ANGLES[1]), np.sin(ANGLES[1])), BLUE)


def circle(ax):
    """The same forces and slips behind the two maps: the reduced slip is against the reduced force."""
    frame(ax, 1.55, "behind the two maps", "reduced force along x", "along y")
    ax.plot(*ring((1, 1)), color=BLUE)
    for angle in ANGLES:
        force = np.array([np.cos(angle), np.sin(angle)])
        reduced = P**2 * (-MU * force / P**2) / MU  # r' = r_t/mu and g = p^2 d_t/mu, but for a factor
        arrow(ax, force, 0.3 * reduced / np.hypot(*reduced), RED)
    arrow(ax, np.zeros(2), np.array([np.cos(ANGLES[1]), np.sin(ANGLES[1])]), BLUE)


def main():
    parser = argparse.ArgumentParser(prog="tools/study law", description=__doc__)
    parser.add_argument("--docs", action="store_true", help="also refresh the picture in docs/")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "output/law", help="folder of the picture (output/law)")
    options = parser.parse_args()
    figure, (left, right) = plt.subplots(1, 2, figsize=(docs_page.WIDTH, 3.6), layout="constrained")
    ellipses(left)
    circle(right)
    docs_page.headline(figure, "Two maps make every law a circle, on which slip is against the force")
    docs_page.legend_below(figure, [left.plot([], [], color=BLUE)[0], left.plot([], [], color=RED, linestyle="--")[0],
                                    left.plot([], [], color=BLUE, marker=">")[0], left.plot([], [], color=RED, marker=">")[0]],
                           ["friction ellipse (case C)", "slip ellipse", "friction force", "slip against it"], 4)
    for folder in [options.output, *([ROOT / "docs/images"] if options.docs else [])]:
        folder.mkdir(parents=True, exist_ok=True)
        docs_page.save_small(figure, folder / "law.png")
    print(f"law: {options.output / 'law.png'}")
