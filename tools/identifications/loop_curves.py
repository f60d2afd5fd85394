# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The loop of a model behind a rig that gives way, from one run of the model alone.

The rig is in series: measured displacement = displacement of the model + compliance * force along the motion. A run moves the
model to and fro, and its branches tell the change of force since the last turning point over the way of the model. The way of
the rig is then way + compliance * change of force along the motion, whatever the compliance: no compliance needs a run of its
own. A branch does not depend on where it begins, as long as the normal force stays; the fit runs the model again with the
strokes that it has found, so that this is needed for small changes only."""
import dataclasses

import numpy as np

BRANCHES = ("first", "away", "back", "down", "up")  # from rest to the upper end, around the loop to settle, and around it again
# Load steps of the branches. Along an axis of the body they need not be small, but where the force turns in the plane they have an
# error of first order.
ALONG_AXIS, OBLIQUE = (6, 8, 8, 40, 40), (40, 20, 20, 100, 100)
CLUSTER = 1.3  # at first, steps are shorter behind a turning point, where the branch is steep

NEAREST = 1e-3  # of the way


def sense(name):
    """1 where a branch goes along the direction of the motion, and -1 where it goes against it."""
    return -1 if name in ("away", "down") else 1


def first_ways(direction, amplitude):
    """{branch: (m,)}: ways at the load steps of a model in a rig that does not give way, mm."""
    counts = OBLIQUE if np.all(direction) else ALONG_AXIS
    return {name: amplitude * (1 if name == "first" else 2) * (np.arange(1, n + 1) / n)**CLUSTER for name, n in zip(BRANCHES, counts)}


def placed(t, y, n):
    """(n,): places up to 1, the last one of the rising t (m,): half of them lie evenly, and half where the values y (m, k) bend, so
    that the slope changes alike from one to the next. Values of the last run that are nearer than NEAREST have no slope."""
    kept = [0]
    for i in range(1, len(t)):
        if t[i] - t[kept[-1]] > NEAREST * t[-1]:
            kept.append(i)
    t, y = t[kept], y[kept]
    bend = np.linalg.norm(np.diff(np.diff(y, axis=0) / np.diff(t)[:, None], axis=0), axis=1)
    bend = np.concatenate([[0], bend, [0]])
    of_parts = np.cumsum(np.maximum(bend[:-1], bend[1:]))
    measure = t[1:] / t[-1] + of_parts / max(of_parts[-1], 1e-300)
    return np.interp(np.arange(1, n + 1) / n, np.concatenate([[0], measure / measure[-1]]), t / t[-1])


def slopes(t, y):
    """(m, k): slopes at m places t of values y (m, k) such that the cubic between places is as monotone as the values (Fritsch
    and Butland 1984)."""
    step = np.diff(t)[:, None]
    chord = np.diff(y, axis=0) / step
    before, after = chord[:-1], chord[1:]
    first, second = step[:-1] + 2 * step[1:], 2 * step[:-1] + step[1:]
    with np.errstate(divide="ignore", invalid="ignore"):
        inner = np.where(before * after > 0, (first + second) / (second / before + first / after), 0)
    return np.concatenate([chord[:1], inner, chord[-1:]])


def interpolated(t, y, at):
    """(n, k): the values y (m, k) of rising places t (m,) at n places; straight on beyond the last one."""
    d = slopes(t, y)
    i = np.clip(np.searchsorted(t, at, side="right") - 1, 0, len(t) - 2)
    h = (t[i + 1] - t[i])[:, None]
    s = (at - t[i])[:, None] / h
    u = np.minimum(s, 1)
    value = y[i] * (1 + 2 * u) * (1 - u)**2 + y[i + 1] * u**2 * (3 - 2 * u) + h * (d[i] * u * (1 - u)**2 - d[i + 1] * u**2 * (1 - u))
    return value + h * d[i + 1] * (s - u)


@dataclasses.dataclass
class Curves:
    """Branches {name: (way, change)} of one run: way (m + 1,) of the model along its motion since the turning
    point, mm, and change (m + 1, 2) of the force on it along x and y, N; both begin with 0."""
    direction: np.ndarray
    branches: dict

    def of_rig(self, name, compliance):
        """(m + 1,): the way of the rig along a branch, mm."""
        way, change = self.branches[name]
        rig = way + compliance * sense(name) * (change @ self.direction)
        return np.maximum.accumulate(rig) + 1e-12 * abs(rig[-1]) * np.arange(len(rig))  # rising, also where rounding is not

    def change(self, name, compliance, at):
        """(n, 2): change of force, N, where the rig has gone `at` (n,), mm."""
        return interpolated(self.of_rig(name, compliance), self.branches[name][1], np.asarray(at, dtype=float))

    def force(self, loop, compliance):
        """(n, 2): force on the held face at the rows of a measured loop, N, from where the model turns down."""
        bottom = self.change("down", compliance, [2 * loop.amplitude])
        return np.where(loop.is_up[:, None], bottom + self.change("up", compliance, loop.way), self.change("down", compliance, loop.way))

    def steps(self, amplitude, compliance, counts=None):
        """{branch: (m,)}: ways of the model, mm, at which the next run of a loop has its load steps: close to each other where
        the force bends. counts: numbers of steps, those of this run if None."""
        found = {}
        for name, count in zip(BRANCHES, counts or [len(way) - 1 for way, _ in self.branches.values()]):
            rig, change = self.of_rig(name, compliance), self.branches[name][1]
            at = placed(rig, change, count) * amplitude * (1 if name == "first" else 2)
            found[name] = at - compliance * sense(name) * (self.change(name, compliance, at) @ self.direction)
        return found

    def gap(self, loop, compliance):
        """How far the loop of the model is from closed, N: it is not settled then."""
        return float(np.hypot(*(sum(self.change(name, compliance, [2 * loop.amplitude]) for name in ("down", "up"))[0])))

    def least_compliance(self):
        """The compliance (mm/N, below 0) at which the rig would not move any more."""
        least = [np.min(np.diff(way) / np.maximum(np.abs(np.diff(change @ self.direction)), 1e-300))
                 for way, change in self.branches.values()]
        return -min(least)

    def slides(self):
        """Whether the model slides as a whole at the ends of the loop: there its force hardly grows any more."""
        way, change = self.branches["down"]
        rate = np.abs(np.diff(change @ self.direction) / np.diff(way))
        return bool(rate[-1] < 0.02 * rate.max())
