# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Worn depth along two lines through the middle of what is worn, after some of the steps."""
import numpy as np
from lines import Line

FIELD = "wear_depth"
MOST_PROFILES = 6
BEYOND = 0.15  # of the length that is worn: how far the lines reach on both sides of it


def profile_steps(data):
    """Steps with contact fields between which about the same volume is worn."""
    steps = np.array(data.maps.all_steps)
    volume = np.interp(steps, data.steps, data.history["worn_volume"]) if len(steps) else steps
    if not np.any(volume > 0):
        return []
    wanted = volume[-1] * np.arange(1, MOST_PROFILES + 1) / MOST_PROFILES
    return sorted({int(steps[np.argmin(np.abs(volume - one))]) for one in wanted})


def node_areas(places, quads):
    """A quarter of each quadrilateral around a node."""
    x, y = places[quads].astype(float).transpose(2, 0, 1)
    areas = np.abs(np.sum(x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y, axis=1)) / 2
    return np.bincount(quads.ravel(), np.repeat(areas / 4, 4), len(places))


def middle(maps, depth):
    """The centre of gravity of the worn volume, mm."""
    weights = depth * node_areas(maps.places, maps.quads)
    place = weights @ maps.places / weights.sum()
    near = np.abs(place - maps.data.centre) < 1e-3 * maps.data.radius
    return np.where(near, maps.data.centre, place)  # where nodes are, if the surface is symmetric


def within(place, depths):
    """Rows of what is worn, and of a little beyond it: one on each side at least."""
    worn = np.flatnonzero(np.max(depths, axis=0) > 0)
    if not len(worn):
        return worn
    room = BEYOND * (place[worn[-1]] - place[worn[0]])
    first = min(worn[0] - 1, np.searchsorted(place, place[worn[0]] - room))
    last = max(worn[-1] + 1, np.searchsorted(place, place[worn[-1]] + room, side="right") - 1)
    return np.arange(max(0, first), min(last, len(place) - 1) + 1)


def name_of(data, step):
    block = next((block for block in data.blocks if block.first <= step <= block.last), None)
    if block is None:
        return f"step {step}"
    return block.name if step == block.last else f"{block.name}, step {step}"


def profiles(data, numbers):
    """[{along, across (mm), place (mm), depths (mm, a row for each name)}, ...], and the names of the steps."""
    steps = profile_steps(data)
    if not steps:
        return {"lines": [], "names": []}
    maps = data.maps
    fields = [data.read(maps.name(step), lambda step=step: maps.file(step)[FIELD][maps.nodes].astype(float))
              for step in steps]
    centre, lines = middle(maps, fields[-1]), []
    for axis in (0, 1):
        line = Line(maps.places, maps.quads, axis, centre[1 - axis])
        depths = np.array([line.of(depth) for depth in fields])
        rows = within(line.place, depths)
        if len(rows) > 1:
            lines.append({"along": "xy"[axis], "across": float(centre[1 - axis]), "place": numbers(line.place[rows]),
                          "depths": [numbers(depth) for depth in depths[:, rows]]})
    return {"lines": lines, "names": [name_of(data, step) for step in steps]}
