# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The border of a contact surface, whatever its form: polygons around it, and around its holes."""
import numpy as np

STRAIGHT = 1e-4  # sine of the angle between edges that are one


def distinct(points):
    """One point of each node (cells may have points of their own), and the node of each point."""
    places = np.round(points / (1e-6 * np.abs(points).max())).astype(np.int64)
    _, one, node = np.unique(places, axis=0, return_index=True, return_inverse=True)
    return one, node.reshape(-1)


def area(polygon):
    """Positive where the polygon runs anticlockwise."""
    x, y = np.transpose(polygon)
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) / 2)


def border_edges(places, quads):
    """Edges of only one of the quadrilaterals, (n, 2), with the surface on their left. A triangle is a quadrilateral
    whose last point is its first."""
    x, y = places[quads].transpose(2, 0, 1)
    clockwise = np.sum(x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y, axis=1) < 0
    quads = np.where(clockwise[:, None], quads[:, ::-1], quads)  # mirrored cells run the other way
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2)
    edges = edges[edges[:, 0] != edges[:, 1]]
    n = len(places)
    forward, backward = edges @ [n, 1], edges @ [1, n]
    return edges[~np.isin(forward, backward)]


def loops(edges):
    """The edges, joined end to end: a closed row of points each."""
    following = {}
    for first, last in edges.tolist():
        following.setdefault(first, []).append(last)
    found = []
    while following:
        start = at = next(iter(following))
        loop = []
        while at in following:
            loop.append(at)
            at = following[at].pop() if len(following[at]) > 1 else following.pop(at)[0]
            if at == start:
                break
        found.append(loop)
    return found


def corners(polygon):
    """Without the points of straight edges."""
    before, after = polygon - np.roll(polygon, 1, axis=0), np.roll(polygon, -1, axis=0) - polygon
    turn = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    return polygon[np.abs(turn) > STRAIGHT * np.hypot(*before.T) * np.hypot(*after.T)]


def outline(places, quads):
    """Polygons with the surface on their left: anticlockwise around it, clockwise around its holes. Neighbours among the
    quadrilaterals share their points."""
    polygons = [corners(places[loop].astype(float)) for loop in loops(border_edges(places, quads))]
    return [polygon for polygon in polygons if len(polygon) > 2]


def clipped(polygon, axis):
    """What of the polygon has no negative coordinate along the axis."""
    out = []
    for start, end in zip(np.roll(polygon, 1, axis=0), polygon):
        if start[axis] * end[axis] < 0:
            out.append(start + (end - start) * start[axis] / (start[axis] - end[axis]))
        if end[axis] >= 0:
            out.append(end)
    return np.array(out).reshape(-1, 2)


def extent(polygons):
    """Centre of the box around them, and their largest distance from it."""
    points = np.concatenate(polygons)
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    return centre, float(np.hypot(*(points - centre).T).max())
