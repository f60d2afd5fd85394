# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Figures 9 to 12 of the paper: slip and forces at the base point P, step by step."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Rectangle

import docs_page
from disc_map import LINES, Surface
from panels import entries
from paper_printed import CYCLE, FORCE_AXIS_END, P_FORCE_X, P_FORCE_Y, P_SLIP, PEAK
from paper_runs import MESHES, place, slip_length

BLUE, RED, GREEN, GREY = LINES


def from_rest(values, stop=None):
    """A history with the state before step 1, which is zero, in front."""
    return np.concatenate([[0], values[:stop]])


def two_panels(**settings):
    return plt.subplots(1, 2, figsize=(docs_page.WIDTH, 3.6), **settings)


def finished(figure, axes, message, columns=2):
    """With the entries of all panels below them."""
    docs_page.legend_below(figure, *entries(axes), columns)
    docs_page.headline(figure, message)
    return figure


def mark_steps(ax, x, y, steps, offset=(5, 3), colour="0.25"):
    for step in steps:
        ax.annotate(str(step), (x[step], y[step]), textcoords="offset points", xytext=offset, fontsize=8, color=colour)


def figure_9(runs):
    """Path of P: case B in two cycles, and case A."""
    figure, axes = two_panels(sharex=True, sharey=True)
    for ax, mesh in zip(axes, ("bricks", "refined")):
        run = runs.case("b", mesh)
        probe, isotropic = run.probe("P"), runs.case("a", mesh).probe("P")
        x, y = (from_rest(probe[name] * 1000, 2 * CYCLE) for name in ("slip_x", "slip_y"))
        first, second = slice(0, CYCLE + 1), slice(CYCLE, 2 * CYCLE + 1)
        ax.plot(x[first], y[first], "-o", color=BLUE, markersize=4, linewidth=2.2, label="B, first cycle")
        ax.plot(x[second], y[second], "--", color=RED, linewidth=1.4, label="B, second cycle (lies on the first)")
        ax.plot(*(from_rest(isotropic[name] * 1000) for name in ("slip_x", "slip_y")), "-s", color=GREEN, markersize=3,
                linewidth=1.2, label="A, isotropic")
        mark_steps(ax, x, y, (PEAK, 12, 13))
        mark_steps(ax, x, y, (1, 14), offset=(-13, 3))  # on the other side there are the other curves
        ax.set_title(f"{MESHES[mesh].title}\nP at {place(run, 'P')}")
        ax.set_xlabel("slip along x (µm)")
        ax.set(xlim=(-0.5, 12.5), ylim=(-0.5, 12.5), aspect="equal")
    axes[0].set_ylabel("slip along y (µm)")
    return finished(figure, axes, "P slips to the peak on a line, and back on a curve (numbers: steps of B)", 3)


def figure_10(runs):
    """Path of the friction force at P and at its neighbour R over one cycle of case B; of the traction as well."""
    figure, axes = two_panels()
    run = runs.case("b", "bricks")
    axes[0].add_patch(Rectangle((P_FORCE_X[0], P_FORCE_Y[0]), np.ptp(P_FORCE_X), np.ptp(P_FORCE_Y), color="0.9",
                                label="printed range, about"))
    for name, colour, offset in (("P", BLUE, (-5, 7)), ("R", RED, (5, -10))):
        path = [from_rest(run.probe(name)[column], CYCLE) for column in ("force_x", "force_y")]
        axes[0].plot(*path, "-o", color=colour, markersize=4, linewidth=1.5, label=f"{name}, {place(run, name)}")
        mark_steps(axes[0], *path, (PEAK, 7, 9, 10, 12), offset, colour)
    axes[0].set_title(f"friction force, {MESHES['bricks'].title}")
    axes[0].set_xlabel("$r_x$ (N)")
    axes[0].set_ylabel("$r_y$ (N)")
    for mesh, colour in (("bricks", BLUE), ("refined", GREEN)):
        probe = runs.case("b", mesh).probe("P")
        path = [from_rest(probe[column], CYCLE) for column in ("traction_x", "traction_y")]
        axes[1].plot(*path, "-o", color=colour, markersize=4, linewidth=1.5, label=MESHES[mesh].title)
    axes[1].set_title("friction traction at P")
    axes[1].set_xlabel("$r_x$ per area (MPa)")
    axes[1].set_ylabel("$r_y$ per area (MPa)")
    for ax in axes:
        ax.set_aspect("equal", adjustable="datalim")
    return finished(figure, axes, "The friction force at P turns round in the unloading (numbers: steps)")


def figure_11(runs, positive_load):
    """Slip at P against the step, unloaded to nothing and to a small positive load."""
    figure, axes = two_panels(sharey=True)
    steps = np.arange(3 * CYCLE + 1)
    for mesh, colour in (("bricks", BLUE), ("refined", GREEN)):
        slip = from_rest(slip_length(runs.case("b", mesh).probe("P")) * 1000)
        axes[0].plot(steps, slip, "-o", color=colour, markersize=3, linewidth=1.3, label=MESHES[mesh].title)
    axes[1].plot(steps, from_rest(slip_length(positive_load.probe("P")) * 1000), "-o", color=BLUE, markersize=3,
                 linewidth=1.3, label=MESHES["bricks"].title)
    for ax, title in zip(axes, ("unloaded to $u_z$ = 0, as in the paper", "unloaded to $u_z$ = -0.02 mm")):
        ax.axhline(P_SLIP * 1000, color="0.4", linestyle=":", label="printed peak, about")
        ax.set_title(title)
        ax.set_xlabel("step")
        ax.set_xticks(steps[::5])
    axes[0].set_ylabel("slip at P (µm)")
    axes[0].set_ylim(0, 15)
    return finished(figure, axes, "Slip at P repeats itself only if the body is unloaded fully", 3)


def friction_on_half(run, step, axis):
    """Sum of the friction forces along x (axis 0) or y (1) on the half of the base where that coordinate is positive,
    positive towards the other half (N)."""
    surface = Surface(run, step)
    half = surface.points[:, axis] > 1e-6
    return -surface["nodal_force"][half, axis].sum()


def figure_12(runs):
    """Total normal force, and friction on half of the base, against slip at P in the first cycle of case B."""
    figure, axes = two_panels()
    for mesh, colour in (("bricks", BLUE), ("refined", GREEN)):
        run = runs.case("b", mesh)
        slip = from_rest(slip_length(run.probe("P")) * 1000, CYCLE)
        force = from_rest(run.history["force_z"] / 1000, CYCLE)
        axes[0].plot(slip, force, "-o", color=colour, markersize=4, linewidth=1.5, label=MESHES[mesh].title)
        for axis, line in ((0, "-o"), (1, "--s")):
            friction = from_rest([friction_on_half(run, step, axis) / 1000 for step in range(1, CYCLE + 1)])
            axes[1].plot(slip, friction, line, color=colour, markersize=4, linewidth=1.5,
                         label=f"along {'xy'[axis]}, {MESHES[mesh].title}")
        if mesh == "bricks":
            mark_steps(axes[0], slip, force, (1, PEAK, 7, 9, 11, 12, 13))
    axes[0].set_ylabel("total normal force (kN)")
    axes[1].set_ylabel("friction on half of the base (kN)")
    for ax in axes:
        ax.axhline(FORCE_AXIS_END / 1000, color="0.4", linestyle=":", label="end of the printed axis")
        ax.set_xlabel("slip at P (µm)")
    return finished(figure, axes, "The total force is beyond the printed axis, friction is not (numbers: steps)", 3)
