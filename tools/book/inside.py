# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Stresses inside of a body below a load that is no contact."""
import numpy as np

import answers
import run_folder
from row import Row, Scene

SQUARE, PRESSURE = Scene("pressed_square"), 0.001
LIMIT = "block of 10 sides: 0.5 %; cells of a sixth of a side"


def on_axis(run):
    """Depths below the top and stresses there (MPa, 9 components), means over the cells that meet."""
    volume = run_folder.Vtu(run.path / "volume-0001.vtu")
    points = volume.points.astype(float)
    chosen = np.all(np.abs(points[:, :2]) < 1e-6, axis=1)
    depths, place = np.unique(np.round(points[:, 2].max() - points[chosen, 2], 5), return_inverse=True)
    stress = volume.fields["stress"][chosen].reshape(-1, 9).astype(float)
    return depths, np.stack([np.bincount(place, column) / np.bincount(place) for column in stress.T], axis=1)


def mises(runs, scene):
    """Largest von Mises stress on the axis, by the pressure: of a curve through the places about it."""
    depths, stress = on_axis(runs(scene))
    near = (depths > 0.15) & (depths < 0.75)
    curve = np.polynomial.Polynomial.fit(depths[near], np.abs(stress[near, 8] - stress[near, 0]) / PRESSURE, 4)
    return float(curve(np.linspace(0.25, 0.55, 301)).max())


def mean_normal_stress(runs, scene):
    stress = on_axis(runs(scene))[1][0]
    return float((stress[0] + stress[4] + stress[8]) / (3 * PRESSURE))


ROWS = (
    Row("square.mises", SQUARE, "largest von Mises stress below a pressed square, by p", mises,
        answers.largest_mises_below_square(0.28), 0.01, "Love 1929", LIMIT, "CONTACT: 0.665 at the depth 0.4"),
    Row("square.mean", SQUARE, "mean normal stress in its middle, by p", mean_normal_stress,
        answers.below_square(0, 0.28)[1], 0.005, "Love 1929", LIMIT, "CONTACT: -0.853"),
)
