# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Maps of contact surfaces that are not seen from above: the sides of cylinders and cones are unrolled, others projected."""
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


def cut_open(angle, quads):
    """The points of a surface around an axis that is cut where the angle jumps, with new numbers behind the others for
    those that stand at both ends of the map; their angles; and the quads in these numbers."""
    behind = (np.ptp(angle[quads], axis=1) > np.pi)[:, None] & (angle[quads] < 0)
    again, number = np.unique(quads[behind], return_inverse=True)
    quads = quads.copy()
    quads[behind] = len(angle) + number
    return np.concatenate([np.arange(len(angle)), again]), np.concatenate([angle, angle[again] + 2 * np.pi]), quads


def around(points, quads, axis):
    """The chart of a cylinder or a cone about an axis, cut open where the angle jumps; or None.

    A cylinder has its arc and its place along the axis. A cone with r = r0 + k z becomes a sector about its apex: with
    sin(a) = k / sqrt(1 + k^2) the distance from the apex is r / sin(a), and the angle shrinks by sin(a)."""
    across, along = points[:, [(axis + 1) % 3, (axis + 2) % 3]].astype(float), points[:, axis].astype(float)
    radii = np.hypot(*across.T)
    slope, least = np.polyfit(along, radii, 1) if np.ptp(along) > ROUND * radii.max() else (0, radii.mean())
    if np.abs(radii - least - slope * along).max() > ROUND / 2 * radii.max():
        return None
    taken, angles, quads = cut_open(np.arctan2(across[:, 1], across[:, 0]), quads)
    hoop, side = np.zeros((2, len(taken), 3))
    hoop[:, (axis + 1) % 3], hoop[:, (axis + 2) % 3] = -np.sin(angles), np.cos(angles)
    side[:, axis] = 1
    if abs(slope) * np.ptp(along) <= ROUND * radii.max():
        return Chart(np.column_stack([radii.max() * angles, along[taken]]), taken, quads, ("arc", "xyz"[axis]),
                     np.stack([hoop, side], axis=1))
    sine = slope / np.hypot(1, slope)
    side[:, (axis + 1) % 3], side[:, (axis + 2) % 3] = slope * np.cos(angles), slope * np.sin(angles)
    side /= np.hypot(1, slope)
    distance, turn = radii[taken] / sine, angles * sine
    sector = np.stack([np.sin(turn), np.cos(turn)], axis=1)
    directions = np.stack([sector[:, 1:] * hoop + sector[:, :1] * side, sector[:, 1:] * side - sector[:, :1] * hoop], axis=1)
    return Chart(distance[:, None] * sector, taken, quads, ("hoop", "generator"), directions)


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
