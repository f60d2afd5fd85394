# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Loops of force over motion: their area, and what they are without their elastic part, which is so much larger that it
hides them."""
import numpy as np

LEAST_ROWS = 3
LEAST_FORCE = 1e-9  # of the largest one: a force that the load program holds has no elastic part
LEAST_MOTION = 1e-3  # of the largest one: a face that a force holds moves a little, and draws no loop
CLOSED = 1e-2  # of the loop: how far its ends may be from each other
# Motion, force of the plane on the body, and the factor that makes it the force which the page draws: along and about the
# plane that of the top, as fretting loops are drawn, else that of the plane.
COMPONENTS = {"x": ("ux", "force_x", -1), "y": ("uy", "force_y", -1), "z": ("uz", "force_z", 1),
              "rx": ("rx", "moment_x", 1), "ry": ("ry", "moment_y", 1), "rz": ("rz", "moment_z", -1)}
FRETTING = ("ux", "uy", "rz", "Fx", "Fy", "Mz")  # components of a load program that move bodies along each other


def is_fretting(data):
    return any(name in FRETTING for name in data.program.extremes())


def rows_of(block, steps):
    return np.flatnonzero((block.first <= steps) & (steps <= block.last))


def last_part(data):
    """Name and rows of the last whole cycle, for the first ones are not settled yet."""
    steps = data.steps
    cycles = [block for block in data.blocks if block.cycle and len(rows_of(block, steps)) >= LEAST_ROWS]
    whole = [block for block in cycles if block.last <= steps[-1]]
    for block in (whole or cycles)[-1:]:
        return block.name, rows_of(block, steps)
    return "all steps", np.arange(len(steps))


def loop_area(motion, force):
    """Of the closed path through the points, in the sense in which it takes energy up."""
    return float(np.sum((force + np.roll(force, -1)) / 2 * (np.roll(motion, -1) - motion)))


def closed_part(motion, force, rows):
    """The first and the last row of the loop that ends with the last of the rows; None where none closes."""
    if rows[0] > 0:
        rows = np.concatenate([[rows[0] - 1], rows])  # where the cycle begins
    path = np.stack([one[rows] / (np.ptp(one[rows]) or 1) for one in (motion, force)], axis=1)
    closes = np.flatnonzero(np.abs(path - path[-1]).max(axis=1) < CLOSED)
    for first in closes:
        if np.ptp(path[first:, 0]) > 0.5:  # a loop, not a rest
            return rows[first], rows[-1]
    return None


def area_of(data, motion, force, rows):
    """What is said of a closed loop; {} where there is none."""
    part = closed_part(motion, force, rows)
    if not part:
        return {}
    first, last = part
    steps, inside = data.steps, slice(first, last + 1)
    return {"rows": (first, last), "area": abs(loop_area(motion[inside], force[inside])), "loop": f"steps {steps[first]}\u2013{steps[last]}",
            "loop_work": float(data.energy["step_work"][first + 1:last + 1].sum()),
            "loop_dissipation": float(data.history["dissipation"][first + 1:last + 1].sum())}


def departure(data, component, name, rows):
    """The force less the line that fits it best; None where the top does not move in this way, or a force holds still."""
    of_motion, of_force, sign = COMPONENTS[component]
    if of_motion not in data.history or of_force not in data.history:  # older runs have no rotations
        return None
    motion, force = data.history[of_motion], sign * data.history[of_force]
    largest = np.max(np.abs(motion))
    if len(rows) < LEAST_ROWS or largest == 0 or np.ptp(motion[rows]) <= LEAST_MOTION * largest:
        return None
    if np.ptp(force[rows]) <= LEAST_FORCE * np.max(np.abs(force)):
        return None
    stiffness, offset = np.polyfit(motion[rows], force[rows], 1)
    return {"stiffness": stiffness, "offset": offset, "of": name, "values": force - offset - stiffness * motion,
            "least": 1e-9 * np.max(np.abs(force)),
            **area_of(data, np.radians(motion) if component[0] == "r" else motion, force, rows)}


def closed_rows(data):
    """First and last row of the closed fretting loop of the last cycle, where there is one."""
    name, rows = last_part(data)
    found = [departure(data, component, name, rows) for component in ("x", "y", "rz")]
    return next((one["rows"] for one in found if one and "rows" in one), None)


def departures(data):
    """{component: departure} of those that are driven in the cycles."""
    if not data.n_solved:
        return {}
    name, rows = last_part(data)
    found = {component: departure(data, component, name, rows) for component in COMPONENTS}
    return {component: one for component, one in found.items() if one}
