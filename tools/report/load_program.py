# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The load program as the parameter file states it, and which steps stand for a long run."""
import bisect
import dataclasses
import itertools

import numpy as np


@dataclasses.dataclass
class Block:
    """The preload (cycle 0), or a cycle: steps first..last, and the last step of each of its legs."""
    cycle: int
    first: int
    last: int
    ends: list

    @property
    def name(self):
        return f"cycle {self.cycle}" if self.cycle else "preload"

    def part_of(self, steps):
        """Those of the ascending steps that belong to it."""
        return steps[bisect.bisect_left(steps, self.first):bisect.bisect_right(steps, self.last)]


COMPONENTS = ("ux", "uy", "uz", "rx", "ry", "rz", "Fx", "Fy", "Fz", "Mx", "My", "Mz")
UNITS = dict(zip(COMPONENTS, 3 * ["mm"] + 3 * ["degrees"] + 3 * ["N"] + 3 * ["N mm"]))


def parse_target(words):
    """{component: value} of "ux uy uz", or of components and loads by their names, which are never numbers."""
    try:
        values = [float(word) for word in words]
    except ValueError:
        return {name: float(value) for name, value in zip(words[::2], words[1::2])}
    ux, uy, uz = values
    return {"ux": ux, "uy": uy, "uz": uz}


def parse_legs(text):
    """[({component: value}, steps), ...] of "ux uy uz : steps ; uz -0.1 Fx 10 : steps ; ..."."""
    legs = []
    for leg in filter(str.strip, text.split(";")):
        target, steps = leg.split(":")
        steps, _, _parts = steps.partition("*")
        legs.append((parse_target(target.split()), int(steps)))
    return legs


def block_of(cycle, before, legs):
    """The block of these legs, which begins after the step `before`."""
    ends = [before + n for n in itertools.accumulate(n for _, n in legs)]
    return Block(cycle, before + 1, ends[-1], ends)


class LoadProgram:
    def __init__(self, entries):
        self.preload = parse_legs(entries.get("Preload", ""))
        self.legs = parse_legs(entries.get("Legs", ""))
        self.cycles = int(entries.get("Cycles", 1))
        self.preload_steps = sum(n for _, n in self.preload)
        self.cycle_steps = sum(n for _, n in self.legs)

    @property
    def n_steps(self):
        return self.preload_steps + self.cycles * self.cycle_steps

    def blocks(self, steps):
        """Those that have any of the ascending steps; most cycles of a run that jumps have none."""
        steps = np.asarray(steps, dtype=int)
        blocks = [block_of(0, 0, self.preload)] if np.any(steps <= self.preload_steps) else []
        if self.cycle_steps:
            cycles = np.unique((steps[steps > self.preload_steps] - self.preload_steps - 1) // self.cycle_steps)
            blocks += [block_of(cycle + 1, self.preload_steps + cycle * self.cycle_steps, self.legs)
                       for cycle in cycles.tolist()]
        return blocks

    def extremes(self):
        """Largest value of each component that is ever driven away from zero, with its sign."""
        targets = [target for target, _ in self.preload + self.legs]
        largest = {name: max((target.get(name, 0) for target in targets), key=abs, default=0) for name in COMPONENTS}
        return {name: value for name, value in largest.items() if value}

    def largest_loads(self):
        """Largest value of each load, with its sign."""
        targets = [target for target, _ in self.preload + self.legs]
        names = {name for target in targets for name in target} - set(COMPONENTS)
        return {name: max((target.get(name, 0) for target in targets), key=abs) for name in sorted(names)}


class SignalProgram:
    """The program of a program file, as far as the history has come: the page needs no file but the run folder's. Cycles
    are as long as the signal makes them."""

    def __init__(self, history):
        self.history = history
        self.n_steps = len(history["step"])

    def blocks(self, steps):
        cycle, step = np.asarray(self.history["cycle"], dtype=int), np.asarray(self.history["step"], dtype=int)
        begins = np.flatnonzero(np.r_[True, cycle[1:] != cycle[:-1]]) if len(cycle) else []
        ends = [*(begins[1:] - 1), len(cycle) - 1] if len(cycle) else []
        return [Block(int(cycle[i]), int(step[i]), int(step[j]), [int(step[j])]) for i, j in zip(begins, ends)]

    def extremes(self):
        """Largest value of each driven component so far, with its sign."""
        driven = sorted({name for names in self.history["driven"] for name in names.split()}, key=COMPONENTS.index)
        column = {name: f"held_{'force' if name[0] == 'F' else 'moment'}_{name[1]}" if name[0] in "FM" else name
                  for name in driven}
        largest = {name: max(self.history[column[name]], key=abs, default=0) for name in driven}
        return {name: float(value) for name, value in largest.items() if value}

    def largest_loads(self):
        """Largest value so far of each column, of which some are loads."""
        return {name: float(max(values, key=abs, default=0)) for name, values in self.history.items()
                if np.issubdtype(np.asarray(values).dtype, np.number)}


def choose_steps(steps, limit, blocks):
    """At most `limit` of the steps: whole cycles, evenly chosen, so that loops stay loops; where not even two cycles
    fit, steps of the whole run."""
    if len(steps) <= limit:
        return steps
    groups = [part for part in (block.part_of(steps) for block in blocks) if part]
    fitting = limit // max(map(len, groups)) if groups else 0
    if fitting < 2 or len(groups) < 2:
        return spread_steps(steps, limit, blocks)
    return [step for k in evenly(len(groups), fitting) for step in groups[k]]


def spread_steps(steps, limit, blocks):
    """At most `limit` of the steps, over the whole run: the first and the last, ends of legs, where loads turn, and
    evenly spaced ones between them."""
    if len(steps) <= limit:
        return steps
    room = limit - 2
    groups = [sorted({nearest(steps, end) for end in block.ends if end <= steps[-1]}) for block in blocks]
    groups = [group for group in groups if group]
    turns = [step for group in groups for step in group]
    if len(turns) > room:
        fitting = room // max(map(len, groups))
        # All ends of few cycles: every n-th end of all of them might always be the same side of the loop.
        turns = ([step for k in evenly(len(groups), fitting) for step in groups[k]] if fitting > 1
                 else [turns[k] for k in evenly(len(turns), room)])
    chosen = {steps[0], steps[-1], *turns}
    return sorted(chosen | {steps[k] for k in evenly(len(steps), limit - len(chosen))})


def nearest(steps, wanted):
    at = bisect.bisect_left(steps, wanted)
    return min(steps[max(0, at - 1):at + 1], key=lambda step: abs(step - wanted))


def evenly(n, limit):
    return sorted(set(np.linspace(0, n - 1, min(n, limit)).round().astype(int).tolist()))
