# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The picture of fatigue parameters: along the contact surface, below the worst place, and as a map of a section, in which a
short line shows the critical plane. A row for each parameter."""
import matplotlib
import numpy as np
from fields import SURFACE, TITLES, UNITS

matplotlib.use("Agg")
matplotlib.rcParams.update({"font.size": 9, "axes.grid": True, "grid.color": "0.9", "axes.axisbelow": True, "legend.fontsize": 8,
                            "legend.frameon": False, "axes.spines.top": False, "axes.spines.right": False, "svg.hashsalt": "fatigue"})

import matplotlib.pyplot as plt  # noqa: E402

COLOURS = {"body": "#0072b2", "lower body": "#d55e00"}
CRACK = 0.6  # length of the line of the critical plane, in half-widths of the contact


def along_surface(ax, name, bodies, fields, averaged):
    for body in bodies:
        at = body.on_surface[np.abs(body.points[body.on_surface, 1]) < 1e-6]
        at = at[np.argsort(body.points[at, 0])]
        ax.plot(body.points[at, 0], fields[body.name][name].values[at], color=COLOURS[body.name], label=body.name)
        if name in averaged.get(body.name, {}):
            values = averaged[body.name][name].values
            ax.plot(body.points[at, 0], values[at], color=COLOURS[body.name], linestyle="--", label=f"{body.name}, mean")
    unit = f" ({UNITS[name]})" if UNITS[name] else ""
    ax.set(xlabel="x (mm)", ylabel=f"{TITLES[name]}{unit}", ylim=(min(0, ax.get_ylim()[0]), None))


def below(ax, name, bodies, fields, place, depth):
    """Values straight below the worst place."""
    body = next(one for one in bodies if one.name == place.where)
    values = fields[body.name][name].values
    if body.is_section:
        depths = np.linspace(0, depth, 121)
        places = np.column_stack([np.full(121, place.point[0]), body.inward * depths])
        rows, weights, inside = body.triangles.weights(places)
        ax.plot((weights * values[rows]).sum(axis=1)[inside], depths[inside], color=COLOURS[body.name])
    else:
        column = np.flatnonzero(np.linalg.norm(body.points[:, :2] - place.point[:2], axis=1) < 1e-6 * depth)
        column = column[np.argsort(np.abs(body.points[column, 2]))]
        ax.plot(values[column], np.abs(body.points[column, 2]), color=COLOURS[body.name], marker=".")
    ax.set_title(f"below x = {place.point[0]:.3g} mm, {place.where}", fontsize=9)
    ax.set(ylabel="depth (mm)", xlabel=UNITS[name] or "value", ylim=(depth, 0), xlim=(min(0, ax.get_xlim()[0]), None))


def section_map(ax, name, bodies, fields, places, half_width):
    largest = max(np.nanmax(fields[body.name][name].values) for body in bodies)
    for body in bodies:
        shown = ax.tricontourf(*body.points[:, [0, 2]].T, body.triangles.triangles, fields[body.name][name].values,
                               levels=np.linspace(0, largest or 1, 21), cmap="viridis", extend="min")
    plt.colorbar(shown, ax=ax, shrink=0.8, format="%.3g")
    for place in places:
        x, _, z = place.point
        ax.plot(x, z, "o", color="white", markeredgecolor="black", markersize=4)
        if place.normal is not None and np.hypot(place.normal[0], place.normal[2]) > 1e-6:
            way = np.array([-place.normal[2], place.normal[0]]) / np.hypot(place.normal[0], place.normal[2])
            way *= CRACK * half_width * (1 if way[1] * place.below.inward >= 0 else -1)
            back = 0 if place.below.inward else -1  # below a curved surface to both sides
            for colour, width in (("black", 3), ("white", 1.5)):
                ax.plot([x + back * way[0], x + way[0]], [z + back * way[1], z + way[1]], color=colour, linewidth=width)
    ax.set(aspect="equal", xlabel="x (mm)", ylabel="z (mm)")
    ax.grid(False)


def plane_window(ax, bodies, middle, half_width):
    """Of a map around a plane contact surface."""
    ax.axhline(0, color="white", linewidth=0.8)
    low, high = min(body.inward for body in bodies), max(body.inward for body in bodies)
    ax.set(xlim=(middle - 2 * half_width, middle + 2 * half_width), ylim=(2 * half_width * min(low, 0), 2 * half_width * max(high, 0)))


def draw(title, bodies, fields, averaged, places, middle, half_width):
    """A figure. fields, averaged: {body: {name: Field}}; places: {name: [Place]}; middle, half_width: of the contact, mm. A
    curved surface has maps only."""
    names = [name for name in places if places[name]]
    is_section = all(body.is_section for body in bodies)
    if not all(place.below.inward for found in places.values() for place in found):
        figure, axes = plt.subplots(1, len(names), figsize=(4 * len(names), 4), layout="constrained", squeeze=False)
        for ax, name in zip(axes[0], names):
            section_map(ax, name, bodies, fields, places[name], half_width)
            ax.set_title(f"{TITLES[name]} ({UNITS[name]})" if UNITS[name] else TITLES[name], fontsize=9)
        return titled(figure, title)
    figure, axes = plt.subplots(len(names), 3 if is_section else 2, figsize=(11 if is_section else 8, 2.5 * len(names) + 0.5),
                                layout="constrained", squeeze=False)
    for row, name in zip(axes, names):
        along_surface(row[0], name, bodies, fields, averaged)
        row[0].set_xlim(middle - 2 * half_width, middle + 2 * half_width)
        row[0].axvspan(middle - half_width, middle + half_width, color="0.93", zorder=0)
        if name in SURFACE:
            for ax in row[1:]:
                ax.set_axis_off()
            continue
        below(row[1], name, bodies, fields, places[name][0], 2 * half_width)
        if is_section:
            section_map(row[2], name, bodies, fields, places[name], half_width)
            plane_window(row[2], bodies, middle, half_width)
    axes[0, 0].legend(loc="best")
    return titled(figure, title)


def titled(figure, title):
    figure.suptitle(title, x=0.01, ha="left", fontweight="bold", fontsize=10)
    return figure
