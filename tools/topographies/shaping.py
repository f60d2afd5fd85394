# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What is done to a measured surface before it is used: cut, level, mask, fill, thin out, turn over. Each function takes a
Surface and returns another one."""
import dataclasses

import numpy as np
from surface import Surface, WrongSurface, check_size

DEGREES = {"mean": 0, "plane": 1, "quadratic": 2}
ROUNDS = 20  # of outliers that are found, and of the form that is fitted without them
PER_DEVIATION = 1.4826  # standard deviation of normal heights, in medians of their distance from the median


def cropped(surface, x_from, x_to, y_from, y_to):
    """The points between these places, mm, at their places. Raises WrongSurface if they are fewer than 2 x 2."""
    ends, parts = ((x_from, x_to), (y_from, y_to)), []
    for places, spacing, (first, last) in zip(surface.places, (surface.dx, surface.dy), ends):
        slack = 1e-9 * spacing * len(places)
        inside = np.flatnonzero((places >= first - slack) & (places <= last + slack))
        if len(inside) < 2:
            raise WrongSurface(f"--crop {first:g} to {last:g} mm has {len(inside)} points; allowed are at least 2 of those between "
                               f"{places[0]:g} and {places[-1]:g} mm")
        parts.append(slice(inside[0], inside[-1] + 1))
    columns, rows = parts
    if np.isnan(surface.heights[rows, columns]).all():
        raise WrongSurface("--crop: has no measured point there; allowed is a part with some")
    x, y = surface.places
    return Surface(surface.heights[rows, columns], surface.dx, surface.dy, x[columns.start], y[rows.start])


def form(surface, degree):
    """(ny, nx), mm: the polynomial in x and y of this degree (0, 1, 2) that is nearest to all measured points by least squares.
    Its normal equations hold sums of x^i y^j, which are products of matrices, since the points are those of a grid."""
    heights = surface.heights
    is_there = ~np.isnan(heights)
    mean = heights[is_there].mean()
    powers = [np.vander(np.linspace(-1, 1, n), 2 * degree + 1, increasing=True) for n in heights.shape]
    terms = [(i, j) for i in range(degree + 1) for j in range(degree + 1 - i)]
    sums = powers[0].T @ is_there @ powers[1]
    right = powers[0].T @ np.where(is_there, heights - mean, 0) @ powers[1]
    matrix = np.array([[sums[j + m, i + k] for k, m in terms] for i, j in terms])
    found = np.linalg.lstsq(matrix, np.array([right[j, i] for i, j in terms]), rcond=None)[0]
    coefficients = np.zeros((degree + 1, degree + 1))
    for (i, j), value in zip(terms, found):
        coefficients[j, i] = value
    return mean + powers[0][:, :degree + 1] @ coefficients @ powers[1][:, :degree + 1].T


def levelled(surface, degree, outliers=None):
    """Without its form of this degree (0, 1, 2). Points that are further from it than `outliers` standard deviations, as the
    median of all distances tells them, become missing, and the form is fitted again without them, until the same ones are out."""
    heights, out = surface.heights, np.zeros(surface.heights.shape, dtype=bool)
    for _ in range(ROUNDS if outliers else 1):
        kept = surface.with_heights(np.where(out, np.nan, heights))
        rest = heights - form(kept, degree)
        if not outliers:
            break
        middle = np.nanmedian(rest)
        deviation = PER_DEVIATION * np.nanmedian(np.abs(rest - middle)) or np.sqrt(np.nanmean((rest - middle)**2))
        before, out = out, np.abs(rest - middle) > outliers * deviation
        if np.array_equal(before, out):
            break
    return surface.with_heights(np.where(out, np.nan, rest))


def masked(surface, outliers):
    """The heights as they are, but outliers from their mean become missing."""
    return surface.with_heights(np.where(np.isnan(levelled(surface, 0, outliers).heights), np.nan, surface.heights))


def neighbours(surface, missing):
    """Of n missing points: for each of the four sides the flat numbers of their neighbours (4, n), and their weights (4, n),
    1/mm^2, which are 0 beyond the grid."""
    ny, nx = surface.heights.shape
    rows, columns = np.nonzero(missing)
    numbers, weights = [], []
    for j, i, spacing in ((0, 1, surface.dx), (0, -1, surface.dx), (1, 0, surface.dy), (-1, 0, surface.dy)):
        row, column = rows + j, columns + i
        inside = (row >= 0) & (row < ny) & (column >= 0) & (column < nx)
        numbers.append(np.where(inside, row * nx + column, 0))
        weights.append(inside / spacing**2)
    return np.array(numbers), np.array(weights)


def filled(surface, tolerance=1e-10):
    """Missing points get the heights of a membrane that is held by the others: the discrete Laplace equation, by conjugate
    gradients. A plane stays one, and no new height lies beyond those around a hole."""
    missing = np.isnan(surface.heights)
    if not missing.any():
        return surface
    numbers, weights = neighbours(surface, missing)
    diagonal = weights.sum(axis=0)
    level = np.nanmean(surface.heights)
    right = (weights * np.where(missing, 0, surface.heights - level).ravel()[numbers]).sum(axis=0)
    order = np.full(missing.size, len(diagonal))  # the place of a missing point among them; of another one that behind the last
    order[missing.ravel()] = np.arange(len(diagonal))
    order = order[numbers]

    def product(values):
        """Of the matrix: the diagonal, less the neighbours that are missing themselves."""
        return diagonal * values - (weights * np.append(values, 0)[order]).sum(axis=0)
    found, rest = np.zeros(len(diagonal)), right
    way = scaled = rest / diagonal
    size = first = rest @ scaled
    for _ in range(10 * sum(missing.shape)):
        if size <= tolerance**2 * first:
            break
        step = product(way)
        length = size / (way @ step)
        found, rest = found + length * way, rest - length * step
        scaled = rest / diagonal
        before, size = size, rest @ scaled
        way = scaled + size / before * way
    whole = surface.heights.copy()
    whole[missing] = found + level
    return surface.with_heights(whole)


def weights_between(n, n_new):
    """(n_new, n): weights that carry n values to n_new evenly spaced places between the same ends: a line by least squares through
    the neighbours of a place, whose weights fall to 0 within one spacing of the coarser grid. Lines are kept as they are."""
    places = np.linspace(0, n - 1, n_new)
    distance = np.arange(n) - places[:, None]
    weights = np.maximum(1 - np.abs(distance) / max(1, (n - 1) / (n_new - 1)), 0)
    s0, s1, s2 = (np.sum(weights * distance**power, axis=1, keepdims=True) for power in range(3))
    determinant = s0 * s2 - s1**2
    is_line = determinant > 1e-9
    return np.where(is_line, weights * (s2 - s1 * distance) / np.where(is_line, determinant, 1), weights / s0)


def resampled(surface, nx, ny):
    """On nx * ny points between the same ends. Finer points are bilinear; coarser ones are means over their spacing, so that waves
    that they cannot show do not turn up as other ones. Raises WrongSurface for missing points."""
    check_size(nx, ny)
    if surface.n_missing:
        raise WrongSurface(f"--points: has missing points ({surface.n_missing}); allowed are none: --fill fills them")
    old = surface.heights.shape
    heights = weights_between(old[0], ny) @ surface.heights @ weights_between(old[1], nx).T
    return dataclasses.replace(surface, heights=heights, dx=surface.dx * (old[1] - 1) / (nx - 1), dy=surface.dy * (old[0] - 1) / (ny - 1))


def turned_over(surface):
    """As the surface of a body lies that was measured from above and is put upside down: about the axis y, x becomes -x."""
    return dataclasses.replace(surface, heights=surface.heights[:, ::-1], x0=-surface.places[0][-1])
