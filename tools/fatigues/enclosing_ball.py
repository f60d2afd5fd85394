# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The smallest ball around a path: in the plane the minimum circumscribed circle of a path of shear, in the five dimensions of
deviators the ball of Crossland and Dang Van.

The ball of a few points on its border, the support, grows over the point that is farthest outside of it, until none is. The
new support are those of the old one and of the new point whose ball is the smallest that contains them all; all subsets are
tried (Welzl 1991 has the same step). Every step enlarges the ball, so that the search ends, and all paths are searched at once."""
import itertools

import numpy as np

_TOLERANCE = 1e-11  # of the radius: how far a point may lie outside
_FLAT = 1e-12  # of points that lie in a space of fewer dimensions than they could: their ball is that of fewer points
_MOST_STEPS = 200
_AT_ONCE = 20_000_000  # numbers in a path of a batch


def enclosing_balls(paths):
    """paths: (m, n, d), n points of m paths. Returns the centres, (m, d), and the radii, (m,), exact but for rounding."""
    paths = np.asarray(paths, dtype=float)
    m, n, d = paths.shape
    centres, radii = np.empty((m, d)), np.empty(m)
    batch = max(1, _AT_ONCE // max(1, n * d))
    for first in range(0, m, batch):
        rows = slice(first, first + batch)
        centres[rows], radii[rows] = _balls(paths[rows])
    return centres, radii


def _balls(paths):
    origin = (paths.max(axis=1) + paths.min(axis=1)) / 2
    shifted = paths - origin[:, None]
    used = np.any(shifted != 0, axis=(0, 1))
    size = np.abs(shifted).max(axis=(1, 2))
    scale = np.where(size > 0, size, 1)
    centres, radii = np.zeros(origin.shape), np.zeros(len(paths))
    if used.any():
        centres[:, used], radii = _grown(shifted[:, :, used] / scale[:, None, None])
    return origin + centres * scale[:, None], radii * scale


def _farthest(paths, centres):
    squares = ((paths - centres[:, None])**2).sum(axis=2)
    index = np.argmax(squares, axis=1)
    return index, np.sqrt(np.take_along_axis(squares, index[:, None], axis=1)[:, 0])


def _grown(paths):
    """Of paths whose largest coordinate is 1."""
    m, _, d = paths.shape
    one, _ = _farthest(paths, np.zeros((m, d)))
    other, _ = _farthest(paths, paths[np.arange(m), one])
    support = np.full((m, d + 1), -1)
    support[:, 0], support[:, 1:2] = one, other[:, None]
    centres = (paths[np.arange(m), one] + paths[np.arange(m), other]) / 2
    radii = np.linalg.norm(paths[np.arange(m), one] - centres, axis=1)
    active = np.arange(m)
    for _ in range(_MOST_STEPS):
        outside, distance = _farthest(paths[active], centres[active])
        grows = distance > radii[active] + _TOLERANCE
        active, outside = active[grows], outside[grows]
        if not len(active):
            break
        centres[active], radii[active], support[active] = _larger(paths[active], support[active], outside)
    return centres, _farthest(paths, centres)[1]


def _larger(paths, support, outside):
    """The smallest balls of the supports and one more point, which lies on its border: centres, radii, new supports."""
    m, _, d = paths.shape
    rows = np.arange(m)
    new = paths[rows, outside]
    old = np.where((support >= 0)[:, :, None], paths[rows[:, None], support], new[:, None])
    best = np.full(m, np.inf), np.zeros((m, d)), np.full((m, d + 1), -1)
    most = int((support >= 0).sum(axis=1).max())
    for size in range(1, min(d, most) + 1):
        for chosen in itertools.combinations(range(most), size):
            centre, radius = _through(new, old[:, chosen])
            radius[np.any(support[:, chosen] < 0, axis=1)] = np.inf
            inside = ((old - centre[:, None])**2).sum(axis=2).max(axis=1) <= (radius + _TOLERANCE)**2
            better = inside & (radius < best[0])
            best[0][better], best[1][better] = radius[better], centre[better]
            best[2][better] = -1
            best[2][better, 0], best[2][better, 1:size + 1] = outside[better], support[better][:, chosen]
    lost = ~np.isfinite(best[0])  # rounding: as it was, and large enough
    best[1][lost], best[2][lost] = old[lost].mean(axis=1), support[lost]
    best[0][lost] = np.sqrt(((old - best[1][:, None])**2).sum(axis=2).max(axis=1))[lost] + 1
    return best[1], best[0], best[2]


def _through(point, others):
    """The smallest balls with the point (m, d) and the others (m, k, d) on their border: centres, radii; inf where they lie in
    too few dimensions."""
    ways = others - point[:, None]
    gram = np.einsum("mid,mjd->mij", ways, ways)
    squares = np.einsum("mii->mi", gram)
    flat = np.linalg.det(gram) <= _FLAT * np.prod(squares, axis=1)
    gram[flat] = np.eye(ways.shape[1])
    shares = np.linalg.solve(gram, squares[..., None] / 2)[..., 0]
    towards = np.einsum("mi,mid->md", shares, ways)
    return point + towards, np.where(flat, np.inf, np.linalg.norm(towards, axis=1))
