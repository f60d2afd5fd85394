# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The answers: the few figures of a run that a reader looks for first. They are those of summary.json, or come from the
tables where it has none, as while a run goes on."""
import math
import typing

import numpy as np
from markup import element, escape, table

# In the order of the page.
NAMES = {"force_z": "largest force along z", "force_xy": "largest force across z",  # where z is not the normal
         "normal_force": "largest normal force", "tangential_force": "largest tangential force",
         "mu_eff": "largest tangential / normal force", "contact_area": "largest contact area", "stick_area": "stick area",
         "pressure": "largest pressure", "slip_of_contact": "largest slip in contact",
         "last_cycle_energy": "energy dissipated in the last cycle", "dissipation": "energy dissipated since the start",
         "energy_per_area": "largest energy per area since the start", "wear_depth": "largest worn depth"}
NEEDS_SOME = ("tangential_force", "mu_eff", "wear_depth")  # not shown where they are zero
ROUNDING = 1e-6  # of the normal force: a smaller sum of tangential forces is none
LEAST_FORCE = 1e-3  # of the largest normal force: below it a ratio of forces says nothing
ONE_DIGIT = 1e-4  # relative: handy() shows four of them
LARGER_AND_SMALLER = {"mm": {-3: "\u00b5m", -6: "nm"}, "N": {3: "kN", 6: "MN"}, "MPa": {3: "GPa"}}


class Answer(typing.NamedTuple):
    value: float
    unit: str
    step: int


def handy(value, unit):
    """Value and unit with a power of 1000 that leaves a handy number, as the axes of the charts have it."""
    powers = LARGER_AND_SMALLER.get(unit, {})
    size = abs(value)
    power = 3 * math.floor(math.log10(size) / 3 + 1e-9) if size > 0 else 0
    if not (0.1 <= size < 1e4) and power in powers:
        value, unit = value / 10.**power, powers[power]
    unit = unit.replace("^2", "\u00b2").replace(" ", "\u00a0")
    return f"{value:.4g} {unit}".strip().replace("-", "\u2212")


def recorded(data):
    """Those of summary.json."""
    found = {name: data.summary.get("answers", {}).get(name, {}) for name in NAMES}
    return {name: Answer(one["value"], one.get("unit") or "", int(one.get("step") or 0)) for name, one in found.items()
            if one.get("value") is not None}


def of_forces(data, at):
    h = data.history
    normal, tangential = h["force_z"], np.hypot(h["force_x"], h["force_y"])
    found = {"normal_force": at(normal, "N")}
    is_sheared = tangential.max() > ROUNDING * normal.max()
    if is_sheared:
        found["tangential_force"] = at(tangential, "N")
        pressed = normal > LEAST_FORCE * normal.max()
        found["mu_eff"] = at(np.where(pressed, tangential / np.where(pressed, normal, 1), 0), "")
    # Of interest where least sticks: at the largest tangential force, or under the whole load.
    row = int(np.argmax(tangential if is_sheared else normal))
    found["stick_area"] = Answer(float(h["stick_area"][row]), "mm\u00b2", int(data.steps[row]))
    return found


def of_cycles(data):
    """Of the last cycle; that of a jump is the mean of its cycles."""
    cycles, n = data.cycles, len(data.cycles.get("cycle", ()))
    since_start = {"dissipation": Answer(float(data.history["total_dissipation"][-1]), "N mm", int(data.steps[-1]))}
    if not n:
        return since_start
    found = {}
    if "dissipation" in cycles:
        found["last_cycle_energy"] = Answer(float(cycles["dissipation"][-1] / cycles["n_cycles"][-1]), "N mm",
                                            int(cycles["last_step"][-1]))
    return {**found, **(since_start if n > 1 else {})}


def from_tables(data):
    if not data.n_solved:
        return {}

    def at(values, unit):
        """The largest one, and the first step that comes as near to it as the page has digits."""
        largest = float(np.max(values))
        row = int(np.argmax(values >= largest - ONE_DIGIT * abs(largest)))
        return Answer(largest, unit, int(data.steps[row]))
    found = {**of_forces(data, at), **of_cycles(data)}
    for name, column, unit in (("contact_area", "contact_area", "mm\u00b2"), ("pressure", "max_pressure", "MPa"),
                               ("slip_of_contact", "max_slip", "mm"), ("wear_depth", "max_wear_depth", "mm")):
        if column in data.history:
            found[name] = at(data.history[column], unit)
    return found


def answers_of(data):
    """{name: answer}, in the order of the page."""
    found = {**from_tables(data), **({} if data.is_running else recorded(data))}
    if not data.has_normal_z:
        for name in ("normal_force", "tangential_force", "mu_eff"):
            found.pop(name, None)
    return {name: found[name] for name in NAMES
            if name in found and math.isfinite(found[name].value) and (found[name].value or name not in NEEDS_SOME)}


def tile(name, answer):
    small = element("small", f"at step {answer.step}") if answer.step else ""
    words = escape(handy(answer.value, answer.unit))
    return element("div", element("dt", escape(NAMES[name])) + element("dd", words + small), "tile")


def beside_each_other(runs, names):
    """A table with a column for each run."""
    found = [answers_of(data) for data in runs]
    rows = [("", *(data.status()[1].partition("\n")[0].partition(":")[0] for data in runs))]
    for name, words in NAMES.items():
        if any(name in one for one in found):
            rows.append((words, *(handy(one[name].value, one[name].unit) if name in one else "\u2013" for one in found)))
    return table(("", *names), rows, "answers")


def answers(runs, names):
    """Tiles of a single run, a table of several."""
    if len(runs) > 1:
        return beside_each_other(runs, names)
    tiles = "".join(tile(name, answer) for name, answer in answers_of(runs[0]).items())
    return element("dl", tiles, "tiles") if tiles else ""
