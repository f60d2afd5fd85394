# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Marks on a drawing of the bodies: arrows of loads, the axes, the scale, and the limits that leave room for labels."""
import numpy as np
from matplotlib.patches import FancyArrowPatch

from parts import LOAD, round_length

ROOM = 0.58  # part of the width that the drawing takes; labels have the rest
HEIGHT = 0.94  # of the height
NORMAL, MOST_NORMALS = "#7a3f9d", 60  # arrows that a reader can tell apart


def draw_load(ax, view, load, labels, view_of_turns=None):
    """Returns the points that it takes, in the drawing. A section looks at turns about z from a little above."""
    style = {"color": LOAD, "linewidth": 1.6, "shrinkA": 0, "shrinkB": 0, "zorder": 12}
    taken = []
    for arrow in load.arrows:
        start, end = view(arrow.start), view(arrow.end)
        if np.linalg.norm(end - start) < 0.15 * np.linalg.norm(arrow.end - arrow.start):  # it points at the reader
            ax.plot(*start, marker="o", markersize=9, markerfacecolor="white", markeredgecolor=LOAD, zorder=12)
            ax.plot(*start, marker="o", markersize=3, color=LOAD, zorder=13)
        else:
            ax.add_patch(FancyArrowPatch(start, end, arrowstyle="<|-|>" if arrow.is_double else "-|>", mutation_scale=12,
                                         **style))
        taken += [start[None], end[None]]
    if load.arc is not None:
        points = (view_of_turns or view)(load.arc)
        ax.plot(*points[:-2].T, color=LOAD, linewidth=1.6, zorder=12)
        ax.add_patch(FancyArrowPatch(points[-4], points[-1], arrowstyle="-|>", mutation_scale=12, **style))
        taken.append(points)
    labels.add((view_of_turns or view)(load.anchor) if load.arc is not None else view(load.anchor), load.words, LOAD)
    return taken


def set_equal_limits(ax, low, high):
    """Limits with equal scales that fill the axes and have the box from `low` to `high` in the middle."""
    box = ax.get_window_extent()
    scale = min(box.width / (high[0] - low[0]), box.height / (high[1] - low[1]))
    half = np.array([box.width, box.height]) / scale / 2
    middle = (np.asarray(low) + high) / 2
    ax.set_xlim(middle[0] - half[0], middle[0] + half[0])
    ax.set_ylim(middle[1] - half[1], middle[1] + half[1])


def set_limits(ax, points):
    """Those of a drawing with labels beside it."""
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = (low + high) / 2, (high - low) / 2 / [ROOM, HEIGHT]
    set_equal_limits(ax, middle - half, middle + half)
    ax.set_axis_off()


def draw_axes_and_scale(ax, view, size, names):
    """The axes and a bar along x with its length, in the corner below on the left."""
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    length = round_length(0.22 * size)
    corner = np.array([left + 0.05 * (right - left), low + 0.13 * (high - low)])
    for name, axis in zip("xyz", np.eye(3)):
        if name not in names:
            continue
        tip = view(0.55 * 0.22 * size * axis)
        ax.annotate("", corner + tip, corner, arrowprops={"arrowstyle": "-|>", "color": "0.2", "linewidth": 1}, zorder=15)
        ax.text(*(corner + 1.25 * tip), name, color="0.2", ha="center", va="center", zorder=15)
    bar = view(length * np.eye(3)[0])
    start = np.array([left + 0.03 * (right - left), low + 0.03 * (high - low) - min(0, bar[1])])
    end = start + bar
    ax.annotate("", end, start, arrowprops={"arrowstyle": "|-|,widthA=0.25,widthB=0.25", "color": "0.2", "linewidth": 1.2,
                                            "shrinkA": 0, "shrinkB": 0}, zorder=15)
    ax.text(*(end + [0.012 * (right - left), 0]), f"{length:g} mm along x", color="0.2", va="center", fontsize=8.5, zorder=15)


def normals_of(scene):
    """Places of contact nodes and normals of the counterface there, each (n, 3); None where all are z."""
    contact = scene["gap"]["contact"]
    if "normals" not in contact:
        return None
    normals = np.array(contact["normals"], dtype=float)
    return np.array(contact["nodes"], dtype=float)[:len(normals)], normals


def draw_normals(ax, view, normals, length, labels):
    """Arrows of some nodes, from the counterface to the body. Returns their ends."""
    places, directions = normals
    some = np.unique(np.linspace(0, len(places) - 1, min(len(places), MOST_NORMALS)).astype(int))
    ends, starts = places[some], places[some] - length * directions[some]
    for start, end in zip(view(starts), view(ends)):
        ax.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": NORMAL, "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0,
                                                "mutation_scale": 7}, zorder=6)
    labels.add(view(starts)[np.argmax(view(starts)[:, 0])], "normals of the counterface", NORMAL)
    return view(starts)
