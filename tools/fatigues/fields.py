# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""All parameters that are asked for, at points with a stress history."""
import dataclasses
import functools

import numpy as np
from criteria import crossland, dang_van, on_critical_planes
from material import criterion_of
from planes import STEP

PLANES = ("swt", "fatemi_socie", "findley")
INVARIANTS = ("crossland", "dang_van")
SURFACE = ("ruiz_energy", "ruiz_tension")
TITLES = {"swt": "Smith-Watson-Topper", "fatemi_socie": "Fatemi-Socie", "findley": "Findley", "crossland": "Crossland",
          "dang_van": "Dang Van", "ruiz_energy": "Ruiz, tau delta", "ruiz_tension": "Ruiz, sigma_T tau delta"}
UNITS = {"swt": "MPa", "fatemi_socie": "", "findley": "MPa", "crossland": "MPa", "dang_van": "MPa", "ruiz_energy": "N/mm",
         "ruiz_tension": "N^2/mm^3"}


@dataclasses.dataclass
class Field:
    """values: (points,); normals: (points, 3) of critical planes, or None; reference: the value in a bar at its fatigue limit
    in reversed bending, or None."""
    values: np.ndarray
    normals: np.ndarray = None
    reference: float = None


def value_of(name, material, stress, step):
    """A Field without reference."""
    if name in PLANES:
        return Field(*on_critical_planes(criterion_of(name, material), stress, step))
    if name == "crossland":
        return Field(crossland(stress, material.crossland_alpha))
    return Field(dang_van(stress, material.dang_van_a))


@functools.lru_cache(maxsize=None)
def reference(name, material):
    bar = np.zeros((1, 2, 6))
    bar[0, :, 0] = material.bending_limit, -material.bending_limit
    return float(value_of(name, material, bar, STEP).values[0])


def fields_of(names, material, stress, step=STEP):
    """{name: Field} of the parameters of stress histories, (points, steps, 6), MPa."""
    found = {}
    for name in names:
        if name in PLANES + INVARIANTS:
            found[name] = value_of(name, material, stress, step)
            found[name].reference = reference(name, material)
    return found
