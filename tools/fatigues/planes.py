# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The search for the plane on which a parameter is largest: a grid over the hemisphere of normals, then a pattern around the
best of them that turns and shrinks. In sections the grid has the planes that lean out of the section, too."""
import numpy as np

STEP = 5.0  # degrees between normals of the grid
FINEST = 0.05  # degrees, the last step of the pattern
STARTS = 3  # largest places of the grid from which the pattern starts
_APART = 2.5  # steps of the grid between two starts
_NEAR = 0.02  # what planes may lack of the largest lower bound, and are evaluated
_PATTERN, _TURN = 6, np.pi * (3 - np.sqrt(5))
_AT_ONCE = 2_500_000  # planes times steps of a batch of points


def grid(step=STEP, one_side=False):
    """Unit normals (k, 3), about `step` degrees apart, one of each pair of opposite ones. Rings lie around the y axis: planes
    of the section y = 0 (normal in x, z) are among them. one_side: those of y >= 0 and y <= 0 count as the same, which holds
    where a history has neither xy nor yz."""
    n_rings = max(1, int(np.ceil(90 / step)))
    normals = []
    for ring in range(0 if one_side else -n_rings, n_rings + 1):
        latitude = np.pi / 2 * ring / n_rings
        n = max(1, int(np.ceil(180 / step * np.cos(latitude) - 1e-9)))
        angles = np.pi * np.arange(n) / n
        normals.append(np.stack([np.cos(latitude) * np.cos(angles), np.full(n, np.sin(latitude)),
                                 np.cos(latitude) * np.sin(angles)], axis=1))
    return np.concatenate(normals if one_side else normals[1:])


def largest(criterion, stress, step=STEP, finest=FINEST):
    """The largest value of a criterion over all planes, and the normal of that plane.

    criterion: has values(stress, normals) -> (points, planes) and bounds(stress, normals) -> two of these, between which the
    values lie. stress: (points, steps, 6), MPa. step, finest: degrees. Returns (points,), (points, 3)."""
    stress = np.asarray(stress, dtype=float)
    one_side = not np.any(stress[..., [3, 5]])
    normals = grid(step, one_side)
    values, found = np.empty(len(stress)), np.empty((len(stress), 3))
    batch = max(1, _AT_ONCE // (len(normals) * stress.shape[1]))
    for first in range(0, len(stress), batch):
        rows = slice(first, first + batch)
        values[rows], found[rows] = _largest(criterion, stress[rows], normals, np.radians(step), np.radians(finest))
    return values, upwards(found)


def upwards(normals):
    """Of both opposite normals the one with z > 0, or x > 0 where z is 0."""
    z, x = np.where(np.abs(normals[..., 2]) < 1e-9, 0, normals[..., 2]), normals[..., 0]
    return normals * np.where((z < 0) | ((z == 0) & (x < 0)), -1, 1)[..., None]


def _largest(criterion, stress, normals, step, finest):
    values = _on_grid(criterion, stress, normals)
    best, found = np.full(len(stress), -np.inf), np.zeros((len(stress), 3))
    for _ in range(STARTS):
        start = np.argmax(values, axis=1)
        value, normal = _refined(criterion, stress, values[np.arange(len(stress)), start], normals[start], step / 2, finest)
        better = value > best
        best[better], found[better] = value[better], normal[better]
        values[np.abs(normals[start] @ normals.T) > np.cos(_APART * step)] = -np.inf
        if not np.isfinite(values.max()):
            break
    return best, found


def _on_grid(criterion, stress, normals):
    """Values of the planes that come near the largest one, and lower bounds of the others."""
    lower, upper = criterion.bounds(stress, normals[None])
    largest_one = lower.max(axis=1, keepdims=True)
    rows, planes = np.nonzero((upper > largest_one - _NEAR * np.abs(largest_one)) & (upper > lower))
    lower = lower.copy()
    batch = max(1, _AT_ONCE // stress.shape[1] // 4)
    for first in range(0, len(rows), batch):
        row, plane = rows[first:first + batch], planes[first:first + batch]
        lower[row, plane] = criterion.values(stress[row], normals[plane, None])[:, 0]
    return lower


def _around(normals, angles, turn):
    """(m, 6, 3): normals that lie by these angles around others."""
    first = np.cross(normals, np.eye(3)[np.argmin(np.abs(normals), axis=1)])
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(normals, first)
    directions = turn + 2 * np.pi * np.arange(_PATTERN) / _PATTERN
    sideways = np.cos(directions)[:, None] * first[:, None] + np.sin(directions)[:, None] * second[:, None]
    return np.cos(angles)[:, None, None] * normals[:, None] + np.sin(angles)[:, None, None] * sideways


def _refined(criterion, stress, values, normals, step, finest):
    values, normals, steps = values.copy(), normals.copy(), np.full(len(values), step)
    active, turn = np.flatnonzero(np.isfinite(values)), 0.0
    while len(active):
        trial = _around(normals[active], steps[active], turn)
        found = criterion.values(stress[active], trial)
        best = np.argmax(found, axis=1)
        value = found[np.arange(len(active)), best]
        better = value > values[active]
        rows = active[better]
        values[rows], normals[rows] = value[better], trial[better, best[better]]
        steps[active[~better]] /= 2
        active, turn = active[steps[active] >= finest], turn + _TURN
    return values, normals / np.linalg.norm(normals, axis=1, keepdims=True)
