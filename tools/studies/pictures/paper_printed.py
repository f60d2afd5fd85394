# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What the paper prints: Feng, Hjiaj, de Saxce, Mroz, Int. J. Non-Linear Mechanics 41 (2006) 936-948. mm, N."""
import dataclasses

import numpy as np

# Numbers of contour levels; the paper prints the smallest and the largest level only.
SLIP_LEVELS, FORCE_LEVELS = 11, 21
PEAK = 5  # step of the first load peak
UNLOADING = (6, 8, 9, 12)  # steps of fig. 8
CYCLE = 15  # steps
CASES = ("a", "b", "c")
TITLES = {"a": "A: isotropic", "b": "B: orthotropic, associated", "c": "C: orthotropic, non-associated"}
FRICTION_ELLIPSE = {"a": (0.20, 0.20), "b": (0.30, 0.15), "c": (0.30, 0.15)}


@dataclasses.dataclass(frozen=True)
class Peak:
    """Figs. 5 and 6, after step 5."""
    largest_slip: float
    smallest_slip_contour: float  # largest / 151: the lowest level, not the smallest slip
    smallest_force: float  # nodal R_n
    largest_force: float

    def slip_levels(self):
        return np.linspace(self.smallest_slip_contour, self.largest_slip, SLIP_LEVELS)

    def force_levels(self):
        return np.linspace(self.smallest_force, self.largest_force, FORCE_LEVELS)


PRINTED = {"a": Peak(0.0137658, 9.11646e-5, 580.8, 3185.8),
           "b": Peak(0.0204396, 1.35362e-4, 584.8, 3321.6),
           "c": Peak(0.0226411, 1.49952e-4, 588.8, 3191.8)}

# Read off the axes and curves of figs. 10 to 12, so only about right.
P_SLIP = 0.0115
P_FORCE_X = (-650, 150)
P_FORCE_Y = (-250, 200)
FORCE_AXIS_END = 45e3
