# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Where points lie below a contact surface, and how planes lie to it."""
import dataclasses

import numpy as np

_AT_ONCE = 2_000_000  # distances of a batch


@dataclasses.dataclass
class Below:
    """points: (n, 3), mm. inward: +1 above a contact surface in the plane z = 0, -1 below it, 0 if it is curved. axes: (n, 3),
    the normals of the contact surface nearest to the points, up to their signs. depths: (n,), distances from it, mm."""
    points: np.ndarray
    inward: int
    axes: np.ndarray
    depths: np.ndarray

    @classmethod
    def plane(cls, points, inward):
        return cls(points, inward, np.broadcast_to([0.0, 0, 1], points.shape), np.abs(points[:, 2]))

    @classmethod
    def curved(cls, points, nodes, triangles, is_strip=False):
        """Of the triangles (m, 3) between nodes (k, 3) of a contact surface. is_strip: in plane strain nodes lie at both ends of
        the thickness, and y does not count."""
        normals = np.zeros(nodes.shape)
        across = np.cross(nodes[triangles[:, 1]] - nodes[triangles[:, 0]], nodes[triangles[:, 2]] - nodes[triangles[:, 0]])
        for corner in triangles.T:
            normals[corner] = across
        sizes = np.linalg.norm(normals, axis=1)
        nodes, normals = nodes[sizes > 0], normals[sizes > 0] / sizes[sizes > 0, None]
        nearest, batch = np.empty(len(points), dtype=int), max(1, _AT_ONCE // len(nodes))
        counts = np.array([1, 0 if is_strip else 1, 1])
        for first in range(0, len(points), batch):
            ways = (points[first:first + batch, None] - nodes) * counts
            nearest[first:first + batch] = np.argmin((ways**2).sum(axis=2), axis=1)
        return cls(points, 0, normals[nearest], np.linalg.norm((points - nodes[nearest]) * counts, axis=1))

    def __getitem__(self, rows):
        return Below(self.points[rows], self.inward, self.axes[rows], self.depths[rows])

    def inclination(self, normals):
        """Angle between planes and the normal of the contact surface, degrees, 0 to 90: 0 is a crack that goes straight down.
        (n, 3) -> (n,)."""
        return np.degrees(np.arcsin(np.minimum(np.abs((normals * self.axes).sum(axis=1)), 1)))

    def azimuth(self, normals):
        """Direction into which such a crack leans as it goes down, degrees from x towards y, -180 to 180; of a plane that does
        not lean the direction of its normal; nan below a curved surface. (n, 3) -> (n,)."""
        x, y, z = np.where(np.abs(normals) < 1e-9, 0, normals).T
        against = np.where(z * self.inward > 0, -1, 1)
        angles = np.degrees(np.arctan2(y * against + 0.0, x * against + 0.0)) + 0.0
        return np.where(angles <= -180 + 1e-6, 180, angles) if self.inward else np.full(len(angles), np.nan)
