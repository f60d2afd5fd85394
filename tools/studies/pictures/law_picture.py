# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The friction law of a node, as docs/theory.md has it: both ellipses and the circle that they become, and a measured law with
its two maps. Started by tools/study law."""
import argparse
import pathlib

import matplotlib.pyplot as plt
import numpy as np

import docs_page
from panels import BLUE, GREY, RED
from paths import ROOT
from rosette_law import RosetteLaw, Table, cross

MU, P = np.array([0.3, 0.15]), np.array([0.05, 0.2])  # case C of the paper
N_SECTORS = 12
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


def both_ellipses():
    figure, (left, right) = plt.subplots(1, 2, figsize=(docs_page.WIDTH, 3.6), layout="constrained")
    ellipses(left)
    circle(right)
    docs_page.headline(figure, "Two maps make every law a circle, on which slip is against the force")
    docs_page.legend_below(figure, [left.plot([], [], color=BLUE)[0], left.plot([], [], color=RED, linestyle="--")[0],
                                    left.plot([], [], color=BLUE, marker=">")[0], left.plot([], [], color=RED, marker=">")[0]],
                           ["friction ellipse (case C)", "slip ellipse", "friction force", "slip against it"], 4)
    return figure


# --- a measured law ---

def measured_law():
    """Neither symmetric nor associated, and not convex."""
    angles = np.radians(np.arange(0, 360, 10))
    return RosetteLaw(Table(angles, 0.25 * (1 + 0.4 * np.cos(angles - 0.5) + 0.2 * np.cos(3 * angles)), 0.06 * (1 + np.sin(2 * angles))))


def sectors(ax, border, title, reach):
    """What lies between the directions of slip at every 30 degrees, in colours that go around. `border` (n, 2)."""
    parts = np.array_split(np.arange(len(border)), N_SECTORS)
    for k, part in enumerate(parts):
        rim = border[np.append(part, (part[-1] + 1) % len(border))]
        ax.fill(*np.vstack([(0, 0), rim]).T, color=plt.get_cmap("twilight")((k + 0.5) / N_SECTORS), linewidth=0)
        ax.plot(*np.vstack([(0, 0), rim[0]]).T, color="white", linewidth=0.7)
    ax.plot(*np.vstack([border, border[:1]]).T, color="0.2", linewidth=0.9)
    frame(ax, reach, title, "", "")
    ax.tick_params(labelsize=7)


def area_of(sector):
    """Between the origin and a part of a border."""
    return cross(sector[:-1], sector[1:]).sum() / 2


def maps():
    """Slips of one size with the forces against them, and their images. The image of each sector of slips has its area."""
    law, angles = measured_law(), np.radians(np.arange(0, 360, 0.25))
    force = law.force(angles)
    _, _, turning = law.conditions(angles)
    direction = force / np.hypot(*force.T)[:, None]
    slip, reduced = np.stack([np.cos(angles), np.sin(angles)], axis=1), direction / np.sqrt(turning)[:, None]
    for k in range(N_SECTORS):
        part = np.arange(k * 120, k * 120 + 121) % len(angles)
        assert abs(area_of(reduced[part]) / area_of(slip[part]) - 1) < 1e-4
    figure, axes = plt.subplots(1, 4, figsize=(docs_page.WIDTH, 2.25), layout="constrained")
    for ax, border, title, reach in zip(axes, (slip, reduced, force, direction), ("−d", "−g(d)", "force f", "reduced force"),
                                        (1.5, 1.5, 0.45, 1.5)):
        sectors(ax, border, title, reach)
    docs_page.headline(figure, "Sectors of slip keep their area, and share their directions with the forces then")
    return figure


def main():
    parser = argparse.ArgumentParser(prog="tools/study law", description=__doc__)
    parser.add_argument("--docs", action="store_true", help="also refresh the pictures in docs/")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "output/law", help="folder of the pictures (output/law)")
    options = parser.parse_args()
    for name, figure in (("law", both_ellipses()), ("law_maps", maps())):
        for folder in [options.output, *([ROOT / "docs/images"] if options.docs else [])]:
            folder.mkdir(parents=True, exist_ok=True)
            docs_page.save_small(figure, folder / f"{name}.png")
        print(f"law: {options.output / name}.png")
