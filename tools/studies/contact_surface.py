# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Fields of contact files between their nodes, as the polynomials that they are, and norms of their differences.

A cell of a solid model is the image of the unit square under the polynomial through its nodes, which stand at the
Gauss-Lobatto points (the files have bilinear pieces between them). An axisymmetric model has polynomials of the radius
through the nodes themselves, wherever they stand (those of the cell on the axis are other points)."""
import numpy as np

RADIUS = 10.  # of the paper's cylinder, mm


def gauss_lobatto(degree):
    """The nodes of a cell in [0, 1]."""
    inner = np.polynomial.legendre.Legendre.basis(degree).deriv().roots()
    return np.concatenate([[0.], (1 + np.sort(inner.real)) / 2, [1.]])


def lagrange(nodes, places):
    """Values and derivatives at the places (n) of the polynomials of the nodes: (k), or of each place (n, k)."""
    nodes = np.broadcast_to(nodes, (len(places), np.shape(nodes)[-1]))
    k = nodes.shape[1]
    away = places[:, None] - nodes
    values, slopes = np.ones_like(away), np.zeros_like(away)
    for i in range(k):
        for j in set(range(k)) - {i}:
            gap = nodes[:, i] - nodes[:, j]
            slopes[:, i] = (slopes[:, i] * away[:, j] + values[:, i]) / gap
            values[:, i] *= away[:, j] / gap
    return values, slopes


class SolidSurface:
    """The base of a solid model: finds the cells of points once, then interpolates any field."""

    def __init__(self, file):
        self._file = file
        self._places = file.cells[:, file.lattice()].reshape(len(file.cells), -1)
        self._nodes = gauss_lobatto(file.degree)
        self._corners = file.points[self._places, :2].astype(float)

    def locate(self, points):
        """Keeps, of each point, its cell and the weights of its nodes. Points outside take the nearest place found."""
        point, cell = self._candidates(points)
        target, nodes = points[point], self._corners[cell]
        place = np.full(target.shape, 0.5)
        for _ in range(12):
            weights, by_first, by_second = self._shapes(place)
            jacobian = np.stack([np.einsum("nk,nkd->nd", by, nodes) for by in (by_first, by_second)], axis=2)
            error = np.einsum("nk,nkd->nd", weights, nodes) - target
            place = np.clip(place - np.linalg.solve(jacobian, error[:, :, None])[:, :, 0], -0.2, 1.2)
        weights = self._shapes(np.clip(place, 0, 1))[0]
        distance = np.linalg.norm(np.einsum("nk,nkd->nd", weights, nodes) - target, axis=1)
        order = np.lexsort((distance, point))
        best = order[np.unique(point[order], return_index=True)[1]]
        self._cell, self._weights, self.distance = cell[best], weights[best], distance[best]

    def __getitem__(self, name):
        values = self._file[name].astype(float)[self._places[self._cell]]
        return np.einsum("nk,nk...->n...", self._weights, values)

    def _candidates(self, points):
        """Pairs of points and cells whose box, widened by what a chord cuts off a circle, holds the point."""
        low, high = self._corners.min(axis=1), self._corners.max(axis=1)
        margin = 0.1 * np.linalg.norm(high - low, axis=1)[:, None]
        return np.nonzero(((points[:, None] >= low - margin) & (points[:, None] <= high + margin)).all(axis=2))

    def _shapes(self, place):
        first, first_slope = lagrange(self._nodes, place[:, 0])
        second, second_slope = lagrange(self._nodes, place[:, 1])
        return [np.einsum("ni,nj->nij", one, two).reshape(len(place), -1)
                for one, two in ((first, second), (first_slope, second), (first, second_slope))]


class RevolvedSurface:
    """The base of an axisymmetric model, from the nodes along the x axis."""

    def __init__(self, file):
        self._file = file
        on_axis = np.flatnonzero((file.points[:, 1] == 0) & (file.points[:, 0] >= 0))
        radii, first = np.unique(file.points[on_axis, 0].astype(float), return_index=True)
        starts = np.arange(0, len(radii) - 1, file.degree)
        self._places = on_axis[first][starts[:, None] + np.arange(file.degree + 1)]
        self._ends = radii[starts]

    def locate(self, points):
        radius = np.linalg.norm(points, axis=1)
        self._places_of_points = self._places[np.searchsorted(self._ends, radius, side="right") - 1]
        nodes = self._file.points[self._places_of_points, 0].astype(float)
        self._weights = lagrange(nodes, np.minimum(radius, nodes[:, -1]))[0]
        self._direction = points / radius[:, None]

    def __getitem__(self, name):
        values = self._file[name].astype(float)[self._places_of_points]
        if values.ndim == 2:
            return np.einsum("nk,nk->n", self._weights, values)
        radial = np.einsum("nk,nk->n", self._weights, values[:, :, 0])
        return np.column_stack([radial[:, None] * self._direction, np.zeros(len(radial))])


def quarter_rule(n_radial=5, n_panels=12, n_sectors=12, n_angular=4):
    """Points and weights on a quarter of the disc; panels shrink by half towards the rim, where fields are singular."""
    ends = RADIUS * np.concatenate([np.linspace(0, 0.75, 13), 1 - 0.25 * 0.5**np.arange(1, n_panels), [1.]])
    radii, widths = _composite(ends, n_radial)
    angles, arcs = _composite(np.linspace(0, np.pi / 2, n_sectors + 1), n_angular)
    radius, angle = (grid.ravel() for grid in np.meshgrid(radii, angles))
    points = np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])
    return points, (arcs[:, None] * (radii * widths)).ravel()


def _composite(ends, n):
    """Gauss's rule on each of the intervals."""
    places, weights = np.polynomial.legendre.leggauss(n)
    widths = np.diff(ends)[:, None]
    return (ends[:-1, None] + widths * (1 + places) / 2).ravel(), (widths * weights / 2).ravel()


def relative_l2(values, reference, weights):
    """Norm of the difference of two fields relative to that of the reference."""
    square = [np.sum(weights * np.sum(np.reshape(field, (len(weights), -1))**2, axis=1))
              for field in (values - reference, reference)]
    return (square[0] / square[1])**0.5
