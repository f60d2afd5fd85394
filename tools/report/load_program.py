# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The load program as the parameter file states it, and which steps stand for a long run."""
import bisect
import dataclasses

import numpy as np


@dataclasses.dataclass
class Block:
    """The preload, or a cycle: steps first..last."""
    name: str
    first: int
    last: int

    def part_of(self, steps):
        """Those of the ascending steps that belong to it."""
        return steps[bisect.bisect_left(steps, self.first):bisect.bisect_right(steps, self.last)]


def parse_legs(text):
    """[((ux, uy, uz), steps), ...] of "ux uy uz : steps ; ..."."""
    legs = []
    for leg in filter(str.strip, text.split(";")):
        target, steps = leg.split(":")
        legs.append((tuple(float(word) for word in target.split()), int(steps)))
    return legs


class LoadProgram:
    def __init__(self, entries):
        self.preload = parse_legs(entries.get("Preload", ""))
        self.legs = parse_legs(entries.get("Legs", ""))
        self.cycles = int(entries.get("Cycles", 1))

    @property
    def n_steps(self):
        return sum(n for _, n in self.preload) + self.cycles * sum(n for _, n in self.legs)

    def blocks(self):
        first = 1 + sum(n for _, n in self.preload)
        blocks = [Block("preload", 1, first - 1)] if first > 1 else []
        length = sum(n for _, n in self.legs)
        for cycle in range(self.cycles if length else 0):
            blocks.append(Block(f"cycle {cycle + 1}", first + cycle * length, first + (cycle + 1) * length - 1))
        return blocks

    def extremes(self):
        """Largest motion of the top in each direction, with its sign."""
        targets = [target for target, _ in self.preload + self.legs] or [(0, 0, 0)]
        return [max((target[d] for target in targets), key=abs) for d in range(3)]


def choose_steps(steps, limit, blocks):
    """At most `limit` of the steps: whole cycles, evenly chosen, so that loops stay loops; evenly spaced steps where
    not even two cycles fit."""
    if len(steps) <= limit:
        return steps
    groups = [part for part in (block.part_of(steps) for block in blocks) if part]
    fitting = limit // max(map(len, groups)) if groups else 0
    if fitting < 2 or len(groups) < 2:
        return [steps[k] for k in evenly(len(steps), limit)]
    return [step for k in evenly(len(groups), fitting) for step in groups[k]]


def evenly(n, limit):
    return sorted(set(np.linspace(0, n - 1, min(n, limit)).round().astype(int).tolist()))
