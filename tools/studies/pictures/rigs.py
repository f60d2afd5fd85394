# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""A sketch and a loop of each rig of prm/rigs; with --docs the picture of docs/rigs.md. Started by tools/study rigs."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Arc, Polygon
from matplotlib.ticker import MaxNLocator

import docs_page
from panels import BLUE, GREY, RED
from paper_runs import Runs

BODY, GROUND = "#c9dcec", "#d9d2c5"


class RigRuns(Runs):
    """Runs of prm/rigs."""

    def rig(self, name):
        return self.run(name, f"../rigs/{name}", "Output/Probes=", "Output/Contact fields=0")


def shape(ax, points, colour):
    ax.add_patch(Polygon(points, closed=True, facecolor=colour, edgecolor="0.25", linewidth=0.9))


def block(ax, left, right, low, high, colour):
    shape(ax, [(left, low), (right, low), (right, high), (left, high)], colour)


def profile(ax, gap, half_width=1.0, height=1.0, colour=BODY):
    """A body whose lower face is at `gap` above the plane."""
    x = np.linspace(-half_width, half_width, 81)
    shape(ax, [*zip(x, gap(x)), (half_width, height), (-half_width, height)], colour)


def arrow(ax, start, end, name, place, both=False):
    ax.annotate("", end, start, arrowprops={"arrowstyle": "<->" if both else "->", "color": RED, "linewidth": 1.2, "mutation_scale": 7, "shrinkA": 0, "shrinkB": 0})
    ax.text(*place, name, color=RED, fontsize=8, ha="center", va="center")


def press_and_move(ax, names=("Fz", "Fx")):
    arrow(ax, (0, 1.6), (0, 1.05), names[0], (0.3, 1.4))
    arrow(ax, (-1.75, 0.85), (-1.1, 0.85), names[1], (-1.42, 1.1), both=True)


def ground(ax):
    block(ax, -1.8, 1.8, -0.55, 0, GROUND)


def sphere_on_flat(ax):
    ground(ax)
    profile(ax, lambda x: 0.3 * x**2)
    press_and_move(ax)


def cylinder_on_flat(ax):
    for shift in (0.5, 0.25, 0):
        x = np.linspace(-1, 1, 81)
        shape(ax, [(-1.8 + shift, -0.55 + 0.5 * shift), (1.5 + shift, -0.55 + 0.5 * shift), (1.5 + shift, 0.5 * shift),
                   (-1.8 + shift, 0.5 * shift)], GROUND)
        top = 1 + 0.5 * shift
        shape(ax, [*zip(x + shift, 0.3 * x**2 + 0.5 * shift), (1 + shift, top), (-1 + shift, top)], BODY)
    press_and_move(ax)


def crossed_cylinders(ax):
    ground(ax)
    profile(ax, lambda x: 0.5 * x**2)
    ax.text(0, 0.62, "R 25 | 100", fontsize=8, ha="center")
    press_and_move(ax, ("Fz", "ux"))


def rounded_punch(ax):
    ground(ax)
    profile(ax, lambda x: np.where(np.abs(x) < 0.5, 0, 0.7 * (np.abs(x) - 0.5) ** 2))
    press_and_move(ax)


def flat_on_flat(ax):
    ground(ax)
    block(ax, -0.9, 0.9, 0, 1, BODY)
    press_and_move(ax, ("Fz", "ux"))


def torsion(ax):
    ground(ax)
    profile(ax, lambda x: 0.3 * x**2)
    arrow(ax, (0, 1.8), (0, 1.05), "Fz", (0.3, 1.7))
    ax.add_patch(Arc((0, 1.25), 0.9, 0.3, theta1=130, theta2=410, color=RED, linewidth=1.5))
    ax.text(0.68, 1.25, "rz", color=RED, fontsize=8, va="center")


def brushed_plate(ax):
    corners = np.array([(-1.2, -0.4), (0.8, -0.4), (1.4, 0.9), (-0.6, 0.9)])
    shape(ax, corners, BODY)
    along = np.array([np.cos(np.pi / 6), np.sin(np.pi / 6)])
    clip = Polygon(corners, closed=True, transform=ax.transData)
    for shift in np.linspace(-1.6, 1.6, 15):
        middle = np.array([0.1, 0.25]) + shift * np.array([-along[1], along[0]])
        ax.plot(*np.stack([middle - 3 * along, middle + 3 * along]).T, color="0.45", linewidth=0.6, clip_path=clip)
    arrow(ax, (-1.75, 0.25), (-1.05, 0.25), "ux", (-1.45, 0.5), both=True)
    ax.text(0.1, 1.2, "from above; marks at 30°", fontsize=8, ha="center")


def fretting_fatigue(ax):
    block(ax, -1.5, 1.25, -0.55, 0, GROUND)
    ax.plot([-1.5, -1.5], [-0.62, 0.07], color="0.25", linewidth=2.5)  # the end that is held
    profile(ax, lambda x: 0.3 * x**2)
    press_and_move(ax)
    arrow(ax, (1.3, -0.28), (1.95, -0.28), "bulk", (1.62, -0.05), both=True)


SKETCHES = (sphere_on_flat, cylinder_on_flat, crossed_cylinders, rounded_punch, flat_on_flat, torsion, brushed_plate,
            fretting_fatigue)


def draw_loop(ax, history, name):
    """Force (or moment) over motion, behind the preload."""
    turns = name == "torsion"
    behind = history["cycle"] > 0
    motion = history["rz"][behind] if turns else history["ux"][behind] * 1e3
    force = history["held_moment_z" if turns else "held_force_x"][behind]
    ax.axhline(0, color=GREY, linewidth=0.6)
    ax.plot(motion, force, color=BLUE, linewidth=1.2)
    for axis in (ax.xaxis, ax.yaxis):
        axis.set_major_locator(MaxNLocator(3, steps=(1, 2, 5, 10)))
    if turns:
        ax.set_xticks((-0.04, 0, 0.04))
    ax.set_xlabel("rz (degrees)" if turns else "ux (µm)", fontsize=8)
    ax.set_ylabel("Mz (N mm)" if turns else "Fx (N)", fontsize=8)


def rigs(runs):
    n_rows = (len(SKETCHES) + 1) // 2
    figure, axes = plt.subplots(n_rows, 4, figsize=(docs_page.WIDTH, 1.65 * n_rows + 0.3), width_ratios=[1.3, 1, 1.3, 1])
    figure.get_layout_engine().set(w_pad=0.01, wspace=0)
    for ax in axes.flat:
        ax.set_axis_off()
    for number, sketch in enumerate(SKETCHES):
        drawn, loop = axes[number // 2, 2 * (number % 2):2 * (number % 2) + 2]
        drawn.set(xlim=(-1.95, 2.1), ylim=(-0.6, 1.8), aspect="equal")
        sketch(drawn)
        drawn.set_title(sketch.__name__.replace("_", " "))
        loop.set_axis_on()
        draw_loop(loop, runs.rig(sketch.__name__).history, sketch.__name__)
    docs_page.headline(figure, "Eight rigs to start from, and the loop that each of them draws")
    return figure


def main():
    docs_page.main("rigs", __doc__, RigRuns, {"rigs": rigs})
