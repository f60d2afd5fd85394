# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Tractions and slip along the axes x and y of the contact surface."""
import base64

import numpy as np
from load_program import evenly

MOST_POINTS = 240
QUANTITIES = ("pressure", "traction_x", "traction_y", "slip_x", "slip_y", "touches")


def crossings(places, quads, axis, across_at):
    """Where a line along `axis` meets the edges of the quadrilaterals, the other coordinate being `across_at`: its
    coordinate, both ends of the edge, and the share of the second one. Between them fields are linear, as the map draws
    them."""
    along, across = places[:, axis].astype(float), places[:, 1 - axis].astype(float) - across_at
    edges = np.unique(np.sort(np.concatenate([quads[:, [k, (k + 1) % 4]] for k in range(4)]), axis=1), axis=0)
    near = 1e-6 * np.max(np.abs(places))
    side = np.where(np.abs(across) <= near, 0, np.sign(across))
    on = np.flatnonzero(side == 0)
    cut = edges[side[edges[:, 0]] * side[edges[:, 1]] < 0]
    first = np.concatenate([on, cut[:, 0]])
    second = np.concatenate([on, cut[:, 1]])
    from_first, from_second = np.abs(across[first]), np.abs(across[second])
    share = np.where(first == second, 0, from_first / np.maximum(from_first + from_second, 1e-300))
    place = (1 - share) * along[first] + share * along[second]
    order = np.argsort(place, kind="stable")
    order = order[np.concatenate([[True], np.diff(place[order]) > near])] if len(order) else order
    order = order[evenly(len(order), MOST_POINTS)] if len(order) else order
    return place[order], first[order], second[order], share[order]


class Line:
    def __init__(self, places, quads, axis, across_at=0.):
        self.place, self.first, self.second, self.share = crossings(places, quads, axis, across_at)

    def of(self, values):
        """Along the line what the nodes have."""
        return (1 - self.share) * values[self.first] + self.share * values[self.second]

    def values(self, fields):
        """Quantities along the line of {name: values of the nodes}, as one array."""
        stack = np.stack([self.of(fields[name]) for name in QUANTITIES])
        return base64.b64encode(stack.astype("<f4").tobytes()).decode()

    @property
    def payload(self):
        return [float(f"{value:.6g}") for value in self.place]


def fields_of(file, nodes, directions=None):
    """Of nodes, with vectors along x and y, or along the directions (n, 2, 3) of an unrolled surface."""
    def along(vectors):
        return vectors[:, :2].T if directions is None else np.einsum("nkd,nd->kn", directions, vectors)
    columns = (file["pressure"][nodes], *along(file["friction_traction"][nodes]), *along(file["slip"][nodes]),
               file["status"][nodes] > 0)
    return dict(zip(QUANTITIES, columns))
