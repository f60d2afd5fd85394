# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What a run says of its point of a fretting map: the regime of its last cycle, its energy, slip, wear and fatigue."""
import argparse
import pathlib
import sys

import numpy as np
from sweep_runs import Run, RunFolder
from run_folder import BadFile  # isort: skip (sweep_runs makes its folder known)

STICK, PARTIAL, GROSS = REGIMES = ("stick", "partial slip", "gross slip")
COLUMNS = {"regime": "", "stick_share": "", "dissipation": "N mm", "slip_ratio": "", "max_slip": "mm", "worn_volume": "mm^3"}


def stick_share_of(steps):
    """The least share of the area in contact that sticks after one of the steps; 1 where nothing touches. steps: {column of
    history.csv: (n,) array}."""
    touching = steps["contact_area"] > 0
    return float((steps["stick_area"][touching] / steps["contact_area"][touching]).min(initial=1))


def regime_of(steps, least_share):
    """The regime of a cycle. A body slides as a whole where all nodes in contact slip after one of the steps. It sticks where
    at least this share of the contact does after all of them: theory has some slip at each edge, and a mesh shows it by chance."""
    stick, slip = steps["n_stick"], steps["n_slip"]
    if np.any((stick == 0) & (slip > 0)):
        return GROSS
    return STICK if stick_share_of(steps) >= least_share else PARTIAL


def slides_away(summary):
    """Whether the run has ended because friction cannot carry the force of a leg: without equilibrium, the body slides."""
    solver = summary.get("contact_solver", {})
    return isinstance(solver, dict) and solver.get("verdict") == "unbalanced"


class PointRun(Run):
    """A run whose body slides away has not failed: that is what its point says."""

    def slides(self):
        return slides_away(self.summary())

    def is_complete(self):
        return super().is_complete() or self.slides()

    def has_failed(self):
        return self.exit != 0 and not self.slides()

    def state(self):
        return "slides away" if self.exit != 0 and not self.has_failed() else super().state().partition("\n")[0]


def last_cycle(run):
    """The row of the last complete cycle, as {column: number}, and the columns of history.csv in the steps of that cycle."""
    cycles, history = run.cycles, run.history
    if not len(cycles) or not len(cycles["cycle"]):
        return {}, history
    row = {name: values[-1] for name, values in cycles.items()}
    of_cycle = history["cycle"] == row["cycle"]
    if not of_cycle.any():  # it was jumped: the one before is like it
        of_cycle = history["cycle"] == history["cycle"].max()
    return row, {name: values[of_cycle] for name, values in history.items() if isinstance(values, np.ndarray)}


def values_of(folder, least_share):
    """{column: value} of a complete run. Raises OSError and ValueError for files that are missing or damaged."""
    run = RunFolder(folder)
    cycle, steps = last_cycle(run)
    return {"regime": regime_of(steps, least_share), "stick_share": stick_share_of(steps),
            "dissipation": float(cycle["dissipation"] / cycle["n_cycles"]) if cycle else float(steps["dissipation"].sum()),
            "slip_ratio": float(cycle.get("slip_ratio", np.nan)), "max_slip": float(steps["max_slip"].max()),
            "worn_volume": float(steps["worn_volume"][-1])}


def _with_fatigue():
    """The modules of tools/fatigue can be imported."""
    folder = str(pathlib.Path(__file__).resolve().parent.parent / "fatigues")
    if folder not in sys.path:
        sys.path.append(folder)


def check_constants(path):
    """Before anything runs: raises BadFile for constants that are not allowed, and OSError for a file that cannot be read."""
    _with_fatigue()
    import material
    try:
        material.material_of(path)
    except material.WrongMaterial as error:
        raise BadFile(str(error)) from error


def worst_fatigue(folder, name, material):
    """The largest value of a parameter of tools/fatigue in both bodies around the contact; nan where it has none."""
    _with_fatigue()
    import cycle_stresses
    import fatigue
    run = RunFolder(folder)
    given = argparse.Namespace(parameters=[name], within=fatigue.WITHIN, plane_step=fatigue.STEP, steps=None)
    try:
        steps, _, _ = fatigue.chosen_steps(run, given)
        cycle_stresses.check_steps(run, "volume", steps)
        surface = fatigue.Surface(run, steps)
        bodies = fatigue.bodies_of(run, given, steps, surface)
        fields = fatigue.all_fields(bodies, given, fatigue.constants_of(run, material), surface)
    except fatigue.NotInRun:
        return np.nan
    values = [field.values for of_body in fields.values() for field in of_body.values()]
    return float(np.nanmax(np.concatenate(values))) if values else np.nan


def row_of(run, given):
    """The row of a point in map.csv, by the options of the command. A run that ends because the body slides away is a point of gross slip: it has neither a
    last cycle nor its energy."""
    row = {**run.point, **dict.fromkeys(COLUMNS, np.nan), **({given.fatigue: np.nan} if given.fatigue else {})}
    row["regime"] = ""
    summary = run.summary() if run.exit in (0, 3) else {}
    if run.exit in (0, 3) and slides_away(summary):
        row["regime"], row["stick_share"] = GROSS, 0.0
    elif run.exit == 0:
        row |= values_of(run.folder, given.stick_share)
        if given.fatigue:
            row[given.fatigue] = worst_fatigue(run.folder, given.fatigue, given.material)
    status = str(summary.get("status", run.message or "not run")).partition("\n")[0]
    return row | {"exit": run.exit, "status": status, "folder": f"runs/{run.folder.name}"}
