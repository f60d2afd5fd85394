# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Roughness numbers of ISO 25178-2, of heights about their mean. Nothing is filtered and nothing levelled here: the numbers are
those of the surface as it is."""
import numpy as np
from shaping import filled

DECAY = 0.2  # of the autocorrelation, the default of ISO 25178-3
N_DIRECTIONS = 180
# Name: unit, meaning. A unit of um is told in mm by numbers().
NUMBERS = {
    "Sa": ("um", "mean distance from the mean"), "Sq": ("um", "root mean square height"),
    "Sp": ("um", "highest peak"), "Sv": ("um", "deepest valley"), "Sz": ("um", "from the deepest valley to the highest peak"),
    "Ssk": ("", "skewness: below 0 for plateaus with valleys"), "Sku": ("", "kurtosis: 3 for normal heights"),
    "Sdq": ("", "root mean square slope"), "Sdr": ("%", "area beyond that of the flat surface"),
    "Sal": ("um", "shortest distance over which the autocorrelation falls to 0.2"),
    "Str": ("", "that distance over the longest one: 1 for equal texture all around, 0 for lines")}


def corners(surface):
    """(4, n), mm: heights at the corners of all cells that have four, in the order (0, 0), (1, 0), (0, 1), (1, 1) of (x, y)."""
    z = np.pad(surface.heights, (0, 1), mode="wrap") if surface.periodic else surface.heights
    cells = np.stack([z[:-1, :-1].ravel(), z[:-1, 1:].ravel(), z[1:, :-1].ravel(), z[1:, 1:].ravel()])
    return cells[:, ~np.isnan(cells).any(axis=0)]


def slopes(surface):
    """(Sdq, Sdr): the root mean square slope of the surface that is bilinear between its points, as the program reads a gap file,
    and its area beyond 1, as the mean of both triangulations of each cell. nan if no cell has four corners."""
    z00, z10, z01, z11 = corners(surface)
    if not len(z00):
        return np.nan, np.nan
    along_x, along_y = ((z10 - z00) / surface.dx, (z11 - z01) / surface.dx), ((z01 - z00) / surface.dy, (z11 - z10) / surface.dy)
    square = sum(np.mean(a * a + a * b + b * b) / 3 for a, b in (along_x, along_y))
    triangles = [np.mean(np.sqrt(1 + x * x + y * y)) for x in along_x for y in along_y]
    return float(np.sqrt(square)), float(np.mean(triangles)) - 1


def autocorrelation(surface):
    """A function of places (x, y), arrays in mm, whose value is 1 at (0, 0): the mean product of heights so far apart. Of
    surfaces that are not periodic only the points count that have such a partner."""
    z = surface.heights - surface.heights.mean()
    shape = z.shape if surface.periodic else tuple(2 * n for n in z.shape)
    products = np.fft.irfft2(np.abs(np.fft.rfft2(z, shape))**2, shape)

    def at_points(i, j):
        pairs = 1 if surface.periodic else (z.shape[1] - np.abs(i)) * (z.shape[0] - np.abs(j)) / z.size
        return products[j % shape[0], i % shape[1]] / products[0, 0] / pairs

    def at(x, y):
        i, j = (np.floor(place / spacing + 1e-9).astype(int) for place, spacing in ((x, surface.dx), (y, surface.dy)))
        s, t = x / surface.dx - i, y / surface.dy - j
        return ((1 - t) * ((1 - s) * at_points(i, j) + s * at_points(i + 1, j))
                + t * ((1 - s) * at_points(i, j + 1) + s * at_points(i + 1, j + 1)))
    return at


def decay_lengths(surface):
    """(N_DIRECTIONS,), mm: in each direction the distance at which the autocorrelation first falls to 0.2; inf where it does not
    within half of the surface. No height may be missing."""
    step, reach = min(surface.dx, surface.dy) / 2, min(surface.size) / 2
    distance = step * np.arange(1, int(reach / step) + 1)
    angles = np.pi * np.arange(N_DIRECTIONS) / N_DIRECTIONS
    values = autocorrelation(surface)(np.outer(np.cos(angles), distance), np.outer(np.sin(angles), distance))
    values = np.column_stack([np.ones(N_DIRECTIONS), values])
    is_below = values <= DECAY
    first = np.argmax(is_below, axis=1)
    row = np.arange(N_DIRECTIONS)
    last, then = values[row, first - 1], values[row, first]
    share = (last - DECAY) / np.where(last > then, last - then, 1)
    return np.where(is_below.any(axis=1), step * (first - 1 + share), np.inf)


def numbers(surface):
    """{name: value} in the order of NUMBERS; lengths in mm, Sdr as a share. Missing points are left out; those of the
    autocorrelation are filled. nan for what the surface does not have, such as Str where a direction never decays."""
    z = surface.heights[~np.isnan(surface.heights)]
    z = z - z.mean()
    square = np.mean(z**2)
    is_flat = not square > 0
    with np.errstate(divide="ignore", invalid="ignore"):
        skewness, kurtosis = np.mean(z**3) / square**1.5, np.mean(z**4) / square**2
    slope, area = slopes(surface)
    lengths = np.full(1, np.inf) if is_flat else decay_lengths(filled(surface))
    shortest, longest = lengths.min(), lengths.max()
    values = (np.mean(np.abs(z)), np.sqrt(square), z.max(), 0 - z.min(), np.ptp(z), skewness, kurtosis, slope, area,
              shortest if np.isfinite(shortest) else np.nan, shortest / longest if np.isfinite(longest) else np.nan)
    return {name: float(value) for name, value in zip(NUMBERS, values)}
