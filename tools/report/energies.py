# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Energies: of the last cycle in a table that sums up, of every cycle in a row, and of jumped cycles beside computed ones."""
import loops
import numpy as np
from cycle_table import jumped_rows
from markup import element, escape, table

MOST_ROWS = 12
ROUNDING = 1e-8  # of the largest energy
# Motion, force on the held face, force of the counterface (its negative without supports), and what the page calls them.
COMPONENTS = (("ux", "held_force_x", "force_x", "Q_x over u_x"), ("uy", "held_force_y", "force_y", "Q_y over u_y"),
              ("uz", "held_force_z", "force_z", "F_z over u_z"), ("rx", "held_moment_x", "moment_x", "M_x over r_x"),
              ("ry", "held_moment_y", "moment_y", "M_y over r_y"), ("rz", "held_moment_z", "moment_z", "M_z over r_z"))


def number(value):
    return "\u2013" if value is None else f"{value:.5g}".replace("-", "\u2212")


class PartEnergy:
    """What the steps first..last of the rows of the history take and where it goes, N mm: work = dissipation + change +
    rest."""

    def __init__(self, data, name, rows):
        energy, (first, last) = data.energy, rows
        self.name, self.part, self.scale = name, slice(first, last + 1), energy["scale"]
        self.steps = f"steps {data.steps[first]}\u2013{data.steps[last]}"
        self.work, self.dissipation = (float(energy[name][self.part].sum()) for name in ("step_work", "step_dissipation"))
        self.change = self.rest = None
        if not data.starts_unknown[first]:
            self.change = float(energy["elastic"][last] - (energy["elastic"][first - 1] if first else 0))
            self.rest = self.cleaned(self.work - self.change - self.dissipation)

    @property
    def remainder(self):
        """Change and rest together, where only both are known."""
        return self.work - self.dissipation

    def cleaned(self, value):
        return 0. if abs(value) < ROUNDING * self.scale else value

    def of_components(self, data):
        """{loop: work of this component alone}, by the trapezoidal rule, of those that matter."""
        found, h = {}, data.history
        for motion, held, of_plane, name in COMPONENTS:
            if motion not in h or of_plane not in h:
                continue
            force = h[held] if held in h else -h[of_plane]
            path = np.radians(h[motion]) if motion[0] == "r" else h[motion]
            mean = (force + np.concatenate([[0], force[:-1]])) / 2
            if work := self.cleaned(float((mean * np.diff(path, prepend=0))[self.part].sum())):
                found[name] = work
        return found


def of_block(data, block):
    first, last = np.searchsorted(data.steps, (block.first, block.last + 1))
    return PartEnergy(data, block.name, (first, last - 1))


def name_of_work(loop):
    """Along the contact surface it is the area of a fretting loop."""
    force = loop.split()[0]
    return f"work of {force} alone" + (f": the area of {loop}" if force in ("Q_x", "Q_y", "M_z") else f" ({loop})")


def rest_words(data):
    return "what the load steps leave open" + (", and what leaves with worn material" if data.wears else "")


def table_that_sums_up(data, parts):
    """Of a closed loop and of the cycle that it is a part of: a reader sees why area, work and dissipation differ."""
    works = [part.of_components(data) for part in parts]
    rows = [(name_of_work(loop), *(number(work.get(loop, 0)) for work in works), "force times motion of this component")
            for loop in dict.fromkeys(loop for work in works for loop in work)]
    others = [part.cleaned(part.work - sum(work.values())) for part, work in zip(parts, works)]
    if any(abs(other) > 1e-4 * abs(part.work) for other, part in zip(others, parts)):
        of_loads = bool(data.parameters.get("Load program", {}).get("Loads"))
        rows.append(("work of the loads", *map(number, others), "pressures, tractions and other loads") if of_loads else
                    ("correction", *map(number, others), "nodes that touch or leave within a load step"))

    def row(name, value, meaning):
        return name, *(number(getattr(part, value)) for part in parts), meaning
    rows += [row("= work of all components", "work", "column work of cycles.csv"),
             row("\u2212 dissipated by friction", "dissipation", "column dissipation of cycles.csv")]
    if any(part.change is None for part in parts):
        rows.append(row("= change of elastic energy, and rest", "remainder", "behind a jump that wears only their sum is known"))
    else:
        rows += [row("\u2212 change of elastic energy", "change", "stored at the end, less what was stored before"),
                 row("= rest", "rest", rest_words(data))]
    heads = ("N mm", *(f"{part.name}, {part.steps}" for part in parts), "what it counts")
    return element("h3", "Where the work goes") + table(heads, rows, "ledger sums")


def computed_and_jumped(data):
    """Of a run that has jumped cycles: steps that were computed, cycles that were not, and both; else nothing."""
    if not len(data.cycles.get("cycle", ())) or not np.any(jumped_rows(data)):
        return ""
    rows, energy = jumped_rows(data), data.energy
    n_jumped = int(data.cycles["n_cycles"][rows].sum())
    lines = []
    for name, words in (("work", "work of all components"), ("dissipation", "dissipated by friction")):
        jumped = float(data.cycles[name][rows].sum())
        computed = float(energy[f"step_{name}"].sum())
        lines.append((words, number(computed), number(jumped), number(computed + jumped)))
    head = ("N mm", f"{data.n_solved} computed steps", f"{n_jumped} jumped cycles", "the whole run")
    hint = ("The first number is the sum of the column dissipation of history.csv, the last one the column total_dissipation. "
            "A jumped cycle counts as much as the cycles between which it lies.")
    return (element("h3", "Computed and jumped cycles") + table(head, lines, "ledger jumps")
            + element("p", escape(hint), "hint"))


def every_cycle(data, energies):
    """A row for each cycle, which sums up."""
    note = ""
    if len(energies) > MOST_ROWS:
        half = MOST_ROWS // 2
        note = element("p", f"The first and the last {half} of {len(energies)} rows.", "hint")
        energies = energies[:half] + energies[-half:]
    rows = []
    for one in energies:
        share = f"{abs(one.rest) / one.dissipation:.3%}" if one.dissipation > 0 and one.rest is not None else "\u2013"
        rows.append((f"{one.name} ({one.steps})",
                     *map(number, (one.work, one.dissipation, one.change, one.rest)), share))
    head = ("N mm", "work of all components", "= dissipated by friction", "+ change of elastic energy", "+ rest",
            "rest / dissipated")
    source = ("recorded by the program" if len(data.checks.get("work", ())) == data.n_solved
              else "by the trapezoidal rule from force and motion of the held face")
    hint = f"Work: {source}. Rest: {rest_words(data)}; more load steps make it smaller where slip turns round."
    if any(one.rest is None for one in energies):
        hint += " \u2013: not known behind a jump that wears, because what was stored at its end is not written."
    return element("h3", "Every cycle") + table(head, rows, "ledger cycles") + note + element("p", escape(hint), "hint")


def ledger(data):
    """All tables of energies."""
    if not data.energy or not data.blocks:
        return ""
    energies = [of_block(data, block) for block in data.blocks]
    whole = [one for one, block in zip(energies, data.blocks) if block.cycle and block.last <= data.steps[-1]]
    parts = [(whole or energies)[-1]]
    if loop := loops.closed_rows(data):
        closed = PartEnergy(data, "closed loop", (loop[0] + 1, loop[1]))  # from the state after its first row
        parts = [closed, *parts] if closed.steps != parts[0].steps else parts
    return table_that_sums_up(data, parts) + every_cycle(data, energies) + computed_and_jumped(data)
