# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Figures 5 to 8 of the paper: maps of the contact surface at the first peak and in the first unloading."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Ellipse
from matplotlib.ticker import MaxNLocator

import run_folder
from disc_map import Surface, axes_cross, contours, status_legend, status_map
from paper_printed import CASES, FRICTION_ELLIPSE, PEAK, PRINTED, TITLES, UNLOADING
from paper_runs import MESHES

PRESSURE_LEVELS = np.linspace(2050, 2550, 11)  # MPa; without friction and clamping E u/H = 2100; singular at the rim
COLUMN = 3.5  # inches


def three_cases(rows, row_titles):
    """Axes with a row for each of `row_titles` and a column for each case."""
    figure, axes = plt.subplots(rows, 3, figsize=(3 * COLUMN, 3.15 * rows + 0.3), layout="constrained", squeeze=False)
    for row, title in zip(axes, row_titles):
        row[0].set_ylabel(title, fontsize=10)
        axes_cross(row[0])
    return figure, axes


def figure_5(runs):
    """Slip at the peak."""
    figure, axes = three_cases(2, [MESHES["bricks"].title, "refined mesh"])
    for row, mesh in zip(axes, ("bricks", "refined")):
        for ax, case in zip(row, CASES):
            surface, printed = Surface(runs.case(case, mesh), PEAK), PRINTED[case]
            slip = surface["slip_magnitude"] * 1000
            shown = contours(ax, surface, slip, printed.slip_levels() * 1000, "viridis", "white")
            ax.set_title(f"{TITLES[case]}\nlargest slip {slip.max():.2f} µm "
                         f"(printed {printed.largest_slip * 1000:.2f})", fontsize=9.5)
            colour_bar(figure, shown, ax, "slip, µm", printed.slip_levels() * 1000, "{:.2f}")
    return figure


def colour_bar(figure, shown, ax, label, levels, text):
    """A scale with up to 11 ticks; the smallest and the largest level are among them."""
    levels = levels[::len(levels) // 10]
    bar = figure.colorbar(shown, ax=ax, label=label, shrink=0.85)
    bar.set_ticks(levels, labels=[text.format(level) for level in levels], fontsize=7.5)


def figure_6(runs):
    """Nodal force with the paper's levels on two meshes of bricks, and the pressure that causes it."""
    figure, axes = three_cases(4, ["nodal force, bricks, fitted", "nodal force, bricks, core to R/3",
                                   "pressure, bricks, core to R/3", "pressure, refined mesh"])
    for column, case in zip(axes.T, CASES):
        fitted, third, refined = (Surface(runs.case(case, mesh), PEAK) for mesh in ("fitted", "third", "refined"))
        levels = PRINTED[case].force_levels()
        for ax, surface in zip(column[:2], (fitted, third)):
            force = surface.nodal_force
            shown = contours(ax, surface, force, levels, "viridis")
            colour_bar(figure, shown, ax, "nodal force $R_n$, N", levels, "{:.0f}")
            ax.set_title(f"{force.min():.0f} to {force.max():.0f} N", fontsize=9.5)
        column[0].set_title(f"{TITLES[case]}\n{column[0].get_title()} (printed {levels[0]:.0f} to {levels[-1]:.0f})",
                            fontsize=9.5)
        for ax, surface in zip(column[2:], (third, refined)):
            pressure = surface["pressure"]
            shown = contours(ax, surface, pressure, PRESSURE_LEVELS, "cividis")
            colour_bar(figure, shown, ax, "pressure, MPa", PRESSURE_LEVELS, "{:.0f}")
            ax.set_title(f"smallest pressure {pressure.min():.0f} MPa", fontsize=9.5)
        for ax, surface in zip(column, (fitted, third, third)):
            ax.plot(*surface.points[surface.corner_nodes()].T, "o", markerfacecolor="none", color="#d55e00",
                    markersize=9, markeredgewidth=1.3, zorder=2)
    return figure


def figure_7(runs):
    """Stick zone at the peak, with the friction ellipse through the outermost sticking nodes along x."""
    figure, axes = three_cases(2, [MESHES["bricks"].title, "refined mesh"])
    for row, mesh in zip(axes, ("bricks", "refined")):
        for ax, case in zip(row, CASES):
            surface = Surface(runs.case(case, mesh), PEAK)
            status_map(ax, surface)
            a, b = surface.extent(run_folder.STICK)
            mu_x, mu_y = FRICTION_ELLIPSE[case]
            ellipse = Ellipse((0, 0), 2 * a, 2 * a * mu_y / mu_x, fill=False, linestyle="--", linewidth=1,
                              label="friction ellipse through the outermost sticking nodes along x; "
                                    "colours reach half a cell farther")
            ax.add_patch(ellipse)
            ax.set_title(f"{TITLES[case]}\nstick zone, half-axes {a:.2f} × {b:.2f} mm", fontsize=9.5)
    status_legend(figure, ellipse)
    return figure


def figure_8(runs):
    """Stick and slip in the first unloading: three columns of the paper's bricks, three of the refined mesh."""
    figure, axes = plt.subplots(len(UNLOADING), 6, figsize=(12.6, 8.9), layout="constrained")
    for block, mesh in enumerate(("bricks", "refined")):
        for i, case in enumerate(CASES):
            for row, step in enumerate(UNLOADING):
                status_map(axes[row, 3 * block + i], Surface(runs.case(case, mesh), step))
            axes[0, 3 * block + i].set_title(f"{case.upper()}, {MESHES[mesh].title}", fontsize=10)
    for ax, step in zip(axes[:, 0], UNLOADING):
        ax.set_ylabel(f"step {step}", fontsize=11)
    axes_cross(axes[0, 0])
    status_legend(figure)
    return figure


def overview(runs):
    """Slip, pressure and status of the three cases with quadratic elements: the README's picture."""
    figure, axes = plt.subplots(3, 3, figsize=(10.5, 9.6), layout="constrained")
    for row, case in zip(axes, CASES):
        run = runs.case(case, "q2")
        peak = Surface(run, PEAK)
        slip, pressure = peak["slip_magnitude"] * 1000, peak["pressure"]
        shown = contours(row[0], peak, slip, MaxNLocator(11).tick_values(0, slip.max()), "viridis", "white")
        figure.colorbar(shown, ax=row[0], label="slip, µm")
        shown = contours(row[1], peak, pressure, PRESSURE_LEVELS, "cividis")
        figure.colorbar(shown, ax=row[1], label="pressure, MPa")
        status_map(row[2], Surface(run, UNLOADING[1]))
        row[0].set_ylabel(TITLES[case], fontsize=10)
    for ax, title in zip(axes[0], ("slip at the peak", "contact pressure at the peak",
                                   f"status in unloading, step {UNLOADING[1]}")):
        ax.set_title(title)
    axes_cross(axes[0, 0])
    status_legend(figure)
    return figure
