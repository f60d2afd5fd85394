# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Loops of force over motion without their elastic part, which is so much larger that it hides them."""
import numpy as np

LEAST_ROWS = 3


def rows_of(block, steps):
    return np.flatnonzero((block.first <= steps) & (steps <= block.last))


def fitted_part(data):
    """Name and rows of what the line is fitted to: the last whole cycle, for the first ones are not settled yet."""
    steps = data.steps
    cycles = [block for block in data.blocks if block.cycle and len(rows_of(block, steps)) >= LEAST_ROWS]
    whole = [block for block in cycles if block.last <= steps[-1]]
    for block in (whole or cycles)[-1:]:
        return block.name, rows_of(block, steps)
    return "all steps", np.arange(len(steps))


def departure(data, axis, name, rows):
    """The force less the line that fits it best; None where the top does not move along this axis."""
    motion, force = data.history[f"u{axis}"], data.history[f"force_{axis}"]
    largest = np.max(np.abs(motion))
    if len(rows) < LEAST_ROWS or largest == 0 or np.ptp(motion[rows]) <= 1e-9 * largest:
        return None
    stiffness, offset = np.polyfit(motion[rows], force[rows], 1)
    return {"stiffness": stiffness, "offset": offset, "of": name, "values": force - offset - stiffness * motion,
            "least": 1e-9 * np.max(np.abs(force))}


def departures(data):
    """{axis: departure} of the components that are driven in the cycles."""
    if not data.n_solved:
        return {}
    name, rows = fitted_part(data)
    found = {axis: departure(data, axis, name, rows) for axis in "xyz"}
    return {axis: one for axis, one in found.items() if one}
