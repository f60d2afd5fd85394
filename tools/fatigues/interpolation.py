# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Linear interpolation in triangles, whose weights serve all steps and components."""
import numpy as np
from matplotlib.tri import Triangulation


class Triangles:
    """points: (n, 2), mm; triangles: (m, 3)."""

    def __init__(self, points, triangles):
        self.points, triangles = np.asarray(points, dtype=float), np.asarray(triangles)
        corners = self.points[triangles]
        ways = corners[:, 1:] - corners[:, :1]
        area = ways[:, 0, 0] * ways[:, 1, 1] - ways[:, 0, 1] * ways[:, 1, 0]
        self.triangles = triangles[np.abs(area) > 1e-12 * np.abs(area).max()]
        self.find = Triangulation(*self.points.T, self.triangles).get_trifinder()

    def weights(self, places):
        """(k, 2), mm -> the points of the triangles around the places, (k, 3), their weights, (k, 3), and whether a place lies
        in a triangle, (k,)."""
        places = np.asarray(places, dtype=float)
        found = np.asarray(self.find(*places.T))
        inside = found >= 0
        rows = self.triangles[np.maximum(found, 0)]
        corners = self.points[rows]
        matrices = np.swapaxes(corners[:, 1:] - corners[:, :1], 1, 2)
        shares = np.linalg.solve(matrices, (places - corners[:, 0])[..., None])[..., 0]
        return rows, np.concatenate([1 - shares.sum(axis=1, keepdims=True), shares], axis=1), inside


def interpolated(values, rows, weights):
    """(n, ...), at points -> (k, ...), at places."""
    return np.einsum("kj,kj...->k...", weights, values[rows])
