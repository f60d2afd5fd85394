# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What is drawn and said of a table: the force and the three conditions all around, also where a table is no law."""
import numpy as np
from rosette_law import CONDITIONS, NotWellPosed, RosetteLaw, cross, unit

N_ANGLES = 1440


class Curve:
    """The law of a table at angles all around (radians). `refusal` says why the program refuses it, or is empty. Where not even
    the rows make a law, their forces are joined by straight lines."""

    def __init__(self, table, n_angles=N_ANGLES):
        self.table, self.law, self.refusal, self.is_joined = table, None, "", True
        try:
            self.law = RosetteLaw(table)
        except NotWellPosed as problem:
            self.refusal = str(problem)
        even = np.linspace(0, 2 * np.pi, n_angles, endpoint=False)
        self.angles = np.unique(np.concatenate([even, table.angles, (table.angles + np.pi) % (2 * np.pi)]))
        try:
            law = self.law or RosetteLaw(table, anyway=True)
            self.forces, self.slopes = law.force(self.angles), law.derivative(self.angles)
        except NotWellPosed:
            self.is_joined = False
            self.forces, self.slopes = self._chords()
        e = unit(self.angles)
        self.along, self.across = (self.forces * e).sum(axis=1), cross(e, self.forces)
        self.size = np.linalg.norm(self.forces, axis=1)
        self.kappa = cross(e, self.slopes)
        with np.errstate(invalid="ignore", divide="ignore"):  # a row without a force
            self.turning = cross(self.forces, self.slopes) / self.size**2

    def _chords(self):
        table = self.table
        i = np.searchsorted(table.angles, self.angles, side="right") - 1  # -1 before the first row
        steps = np.roll(table.forces, -1, axis=0) - table.forces
        part = ((self.angles - table.angles[i]) % (2 * np.pi)) / table.steps[i]
        return table.forces[i] + part[:, None] * steps[i], steps[i] / table.steps[i, None]

    @property
    def mean(self):
        """Of the size of the force over the angle."""
        return float(np.trapezoid(self.size, self.angles) if hasattr(np, "trapezoid") else np.trapz(self.size, self.angles)
                     ) / float(np.ptp(self.angles))

    def departures(self):
        """Angles (radians) from the outward normal of the curve to the direction e that slip is against: 0 where friction is
        associated. kappa > 0 keeps them below 90 degrees."""
        e = unit(self.angles)
        normal = np.stack([self.slopes[:, 1], -self.slopes[:, 0]], axis=1)
        return np.arctan2(cross(normal, e), (normal * e).sum(axis=1))

    def failing(self):
        """{condition: [(first, last angle)]} in radians; last < first where a range goes over 0."""
        return {name: ranges(self.angles, ~(values > 0)) for name, values in zip(CONDITIONS, (self.along, self.kappa, self.turning))}

    def to_and_fro(self):
        """How much the size of friction along a direction differs from that against it, and the angle of its larger one."""
        opposite = (self.angles + np.pi) % (2 * np.pi)
        there = self.along - np.interp(opposite, self.angles, self.along, period=2 * np.pi)
        return float(there.max()), float(self.angles[np.argmax(there)])


def ranges(angles, holds):
    """Where a condition holds without a break, all around."""
    if holds.all():
        return [(0., 2 * np.pi)]
    starts, ends = np.flatnonzero(holds & ~np.roll(holds, 1)), np.flatnonzero(holds & ~np.roll(holds, -1))
    if len(ends) and ends[0] < starts[0]:
        ends = np.roll(ends, -1)
    return [(float(angles[first]), float(angles[last])) for first, last in zip(starts, ends)]
