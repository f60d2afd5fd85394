# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The values of cycles.csv, a row a cycle; a row that stands for several jumped cycles has their mean."""
import numpy as np
from load_program import evenly

MOST_ROWS = 2000
SUMS = ("accumulated_slip", "dissipation", "work", "worst_energy")  # of all cycles that a row stands for
STATES = ("max_slip", "max_accumulated_slip", "total_dissipation", "peak_force_z", "force_z", "change", "iterations",
          "worn_volume", "max_wear_depth", "wear_error", "slip_ratio", "energy_ratio", "friction_largest", "friction_energy",
          "friction_geometric", "loop_stiffness", "stroke", "tangential_force")


def jumped_rows(data):
    """Of a jump no step was computed, so that the history has none of its rows."""
    return ~np.isin(data.cycles["last_step"], data.steps)


def jumps(data):
    """First and last step of each jump."""
    if not len(data.cycles.get("cycle", ())):
        return []
    rows = jumped_rows(data)
    last = data.cycles["last_step"]
    return np.stack([np.r_[0, last[:-1]][rows] + 1, last[rows]], axis=1).astype(int).tolist()


def jumped_energy(data, name):
    """What the cycles jumped before each row of the history have added to an energy."""
    added = np.zeros(data.n_solved)
    if name not in data.cycles:
        return added
    for row in np.flatnonzero(jumped_rows(data)):
        added[np.searchsorted(data.steps, data.cycles["last_step"][row]):] += data.cycles[name][row]
    return added


def chosen_columns(data):
    """{name: values} of the rows on show, without a column `step`; {} without a whole cycle."""
    cycles = data.cycles
    if not len(cycles.get("cycle", ())):
        return {}
    rows = evenly(len(cycles["cycle"]), MOST_ROWS)
    count = cycles["n_cycles"][rows]
    columns = {name: cycles[name][rows] for name in ("cycle", "n_cycles", "last_step", *STATES) if name in cycles}
    columns.update({name: cycles[name][rows] / count for name in SUMS if name in cycles})
    columns["jumped"] = jumped_rows(data)[rows].astype(int)
    return columns
