# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Figures 5 to 8 of the paper: maps of the contact surface at the first peak and in the first unloading."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Ellipse

import docs_page
import run_folder
from disc_map import Surface, axes_cross, contours, levels_of, scale, scale_bar, status_legend, status_map
from docs_page import WIDTH
from paper_printed import CASES, FRICTION_ELLIPSE, PEAK, PRINTED, TITLES, UNLOADING
from paper_runs import MESHES

PRESSURE_LEVELS = np.linspace(2050, 2550, 11)  # MPa; without friction and clamping E u/H = 2100; singular at the rim


def three_cases(rows, row_titles, height=2.2, above=0.5):
    """Axes with a row for each of `row_titles` and a column for each case."""
    figure, axes = plt.subplots(rows, 3, figsize=(WIDTH, height * rows + above), squeeze=False)
    for row, title in zip(axes, row_titles):
        row[0].set_ylabel(title)
        for ax in row:
            axes_cross(ax)
    return figure, axes


def figure_5(runs):
    """Slip at the peak, on the paper's mesh."""
    figure, axes = three_cases(1, [""], 3.2)
    for ax, case in zip(axes[0], CASES):
        surface, printed = Surface(runs.case(case, "bricks"), PEAK), PRINTED[case]
        slip, levels = 1e3 * surface["slip_magnitude"], 1e3 * printed.slip_levels()
        scale(figure, contours(ax, surface, slip, levels, "viridis", "white"), ax, "slip (µm)", levels)
        refined = 1e3 * Surface(runs.case(case, "refined"), PEAK)["slip_magnitude"].max()
        ax.set_title(f"{TITLES[case]}\nlargest {slip.max():.2f} µm\nprinted {1e3 * printed.largest_slip:.2f} µm\n"
                     f"(refined mesh {refined:.2f} µm)")
    docs_page.headline(figure, "On the paper's bricks slip at the peak is as printed")
    return figure


def figure_6(runs):
    """Case B: nodal force with the paper's levels on two meshes of bricks, and the pressure that causes it."""
    figure, axes = plt.subplots(2, 2, figsize=(WIDTH, 6))
    fitted, third, refined = (Surface(runs.case("b", mesh), PEAK) for mesh in ("fitted", "third", "refined"))
    levels = PRINTED["b"].force_levels()
    for ax, surface, name in zip(axes[0], (fitted, third), ("fitted core", "core to R/3")):
        force = surface.nodal_force
        scale(figure, contours(ax, surface, force, levels, "viridis"), ax, "nodal force $R_n$ (N)", levels, "right")
        ax.set_title(f"nodal force, bricks, {name}\n{force.min():.0f} to {force.max():.0f} N")
    for ax, surface, name in zip(axes[1], (third, refined), ("bricks, core to R/3", "refined mesh")):
        pressure = surface["pressure"]
        shown = contours(ax, surface, pressure, PRESSURE_LEVELS, "cividis")
        scale(figure, shown, ax, "pressure (MPa)", PRESSURE_LEVELS, "right")
        ax.set_title(f"pressure, {name}\nfrom {pressure.min():.0f} MPa")
    for ax, surface in zip(axes.flat, (fitted, third, third)):
        ax.plot(*surface.points[surface.corner_nodes()].T, "o", markerfacecolor="none", color="#d55e00", markersize=9,
                markeredgewidth=1.3, zorder=2)
    for ax in axes.flat:
        axes_cross(ax)
    docs_page.headline(figure, "Case B: minima of the nodal force come from the mesh, not from pressure")
    return figure


def figure_7(runs):
    """Stick zone at the peak, with the friction ellipse through the outermost sticking nodes along x."""
    figure, axes = three_cases(2, [MESHES["bricks"].title, "refined mesh"], 2.5)
    for row, mesh in zip(axes, ("bricks", "refined")):
        for ax, case in zip(row, CASES):
            surface = Surface(runs.case(case, mesh), PEAK)
            status_map(ax, surface)
            a, b = surface.extent(run_folder.STICK)
            mu_x, mu_y = FRICTION_ELLIPSE[case]
            ellipse = Ellipse((0, 0), 2 * a, 2 * a * mu_y / mu_x, fill=False, linestyle="--", linewidth=1,
                              label="friction ellipse through the outermost sticking nodes along x")
            ax.add_patch(ellipse)
            ax.set_title(f"{TITLES[case]}\nhalf-axes {a:.2f} × {b:.2f} mm")
    status_legend(figure, ellipse, statuses=(run_folder.STICK, run_folder.SLIP))
    docs_page.headline(figure, "Stick zones of B and C are more slender than the friction ellipse")
    return figure


def figure_8(runs):
    """Stick and slip in the first unloading: three columns of the paper's bricks, three of the refined mesh."""
    figure, axes = plt.subplots(len(UNLOADING), 6, figsize=(WIDTH, 5.2))
    for block, mesh in enumerate(("bricks", "refined")):
        for i, case in enumerate(CASES):
            for row, step in enumerate(UNLOADING):
                status_map(axes[row, 3 * block + i], Surface(runs.case(case, mesh), step))
            axes[0, 3 * block + i].set_title(f"case {case.upper()},\n{mesh}")
    for ax, step in zip(axes[:, 0], UNLOADING):
        ax.set_ylabel(f"step {step}")
    scale_bar(axes[-1, 0], 10)
    status_legend(figure, Line2D([], [], linestyle="none", label="x to the right, y upwards"))
    docs_page.headline(figure, "In the first unloading the rim sticks first, and slips back later")
    return figure


def overview(runs):
    """Slip, pressure and status of the three cases with quadratic elements: the README's picture."""
    figure, axes = plt.subplots(3, 3, figsize=(WIDTH, 6.4))
    for row, case in zip(axes, CASES):
        run = runs.case(case, "q2")
        peak = Surface(run, PEAK)
        slip, pressure = peak["slip_magnitude"] * 1000, peak["pressure"]
        levels = levels_of(0, slip.max())
        scale(figure, contours(row[0], peak, slip, levels, "viridis", "white"), row[0], "slip (µm)", levels, "right")
        shown = contours(row[1], peak, pressure, PRESSURE_LEVELS, "cividis")
        scale(figure, shown, row[1], "pressure (MPa)", PRESSURE_LEVELS, "right")
        status_map(row[2], Surface(run, UNLOADING[1]))
        row[0].set_ylabel(TITLES[case].replace(", ", ",\n"))
        for ax in row:
            axes_cross(ax)
    for ax, title in zip(axes[0], ("slip at the peak", "pressure at the peak", f"unloading, step {UNLOADING[1]}")):
        ax.set_title(title)
    status_legend(figure)
    docs_page.headline(figure, "Friction and slip rule shape slip, pressure and stick zone")
    return figure
