# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Maps of contact surfaces that are not seen from above: the sides of cylinders are unrolled, others projected."""
import typing

import numpy as np

STEEP = 0.1  # cosine of the angle between a face's normal and z, below which a view from above does not show it
ROUND = 0.02  # by which radii may differ, relative: cells of degree 1 and 2 cut the circle


class Chart(typing.NamedTuple):
    """Places (n, 2) in mm of the nodes on the map, the point of the file that each one is, the names of both axes, and their
    directions in space (n, 2, 3)."""

    places: np.ndarray
    points: np.ndarray
    quads: np.ndarray
    axes: tuple = ()
    directions: typing.Any = None


def area_vectors(points, quads):
    corners = points[quads].astype(float)
    return np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])


def around(points, quads, axis):
    """The chart of a cylinder about an axis: arc and place along the axis, cut open where the angle jumps; or None."""
    across = points[:, [(axis + 1) % 3, (axis + 2) % 3]].astype(float)
    radii = np.hypot(*across.T)
    if np.ptp(radii) > ROUND * radii.max():
        return None
    angle = np.arctan2(across[:, 1], across[:, 0])
    jumps = np.ptp(angle[quads], axis=1) > np.pi
    behind = jumps[:, None] & (angle[quads] < 0)  # these corners stand at the other end of the map
    again, number = np.unique(quads[behind], return_inverse=True)
    quads = quads.copy()
    quads[behind] = len(points) + number
    taken = np.concatenate([np.arange(len(points)), again])
    angles = np.concatenate([angle, angle[again] + 2 * np.pi])
    places = np.column_stack([radii.max() * angles, points[taken, axis]])
    directions = np.zeros((len(taken), 2, 3))
    directions[:, 0, (axis + 1) % 3], directions[:, 0, (axis + 2) % 3] = -np.sin(angles), np.cos(angles)
    directions[:, 1, axis] = 1
    return Chart(places, taken, quads, ("arc", "xyz"[axis]), directions)


def unrolled(points, quads):
    """The chart of a surface (points (n, 3), quads of them); None where a view from above shows all of it."""
    vectors = area_vectors(points, quads)
    sizes = np.linalg.norm(vectors, axis=1)
    looks_up = np.sign(vectors[:, 2].sum()) * vectors[:, 2] >= STEEP * sizes
    if looks_up.all():
        return None
    for axis in (2, 1, 0):
        if (chart := around(points, quads, axis)) is not None:
            return chart
    # The plane in which it is largest.
    from_middle = points - points.mean(axis=0)
    directions = np.linalg.svd(from_middle.astype(float), full_matrices=False)[2][:2]
    return Chart(from_middle @ directions.T, np.arange(len(points)), quads, ("first", "second"),
                 np.broadcast_to(directions, (len(points), 2, 3)))
