# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Heights on a regular grid, in mm, and what every reader of them needs: units, bounds, errors of one line."""
import dataclasses
import math

import numpy as np
from run_folder import one_line

MOST_POINTS = 20_000_000  # a spectrum of so many takes two gigabytes
LEAST_SPACING, MOST_LENGTH = 1e-9, 1e6  # mm: squares and slopes of what lies between are numbers
MILLIMETRES = {"mm": 1., "um": 1e-3, "µm": 1e-3, "μm": 1e-3, "nm": 1e-6, "cm": 10., "m": 1e3}


class WrongSurface(ValueError):
    """What is measured or asked for cannot be used; the words are one line, and say what is allowed."""

    def __init__(self, words):
        super().__init__(one_line(words))


@dataclasses.dataclass
class Surface:
    """heights: (ny, nx), mm, upwards, nan where nothing is measured; a row for each y. dx, dy: spacing, mm, > 0. x0, y0: place
    of the first point, mm. periodic: whether the surface goes on with its first row and column behind the last ones."""
    heights: np.ndarray
    dx: float
    dy: float
    x0: float
    y0: float
    periodic: bool = False

    @classmethod
    def centred(cls, heights, dx, dy, periodic=False):
        """Around x = y = 0. heights: (ny, nx), mm; dx, dy: mm. Raises WrongSurface for a spacing, a number of points or heights
        that make no surface."""
        heights = np.asarray(heights, dtype=float)
        check_size(*heights.shape[::-1])
        if not all(LEAST_SPACING <= spacing <= MOST_LENGTH for spacing in (dx, dy)):
            raise WrongSurface(f"has points every {dx:g} and {dy:g} mm; allowed are spacings from {LEAST_SPACING:g} to {MOST_LENGTH:g} mm")
        largest = np.max(np.abs(heights), where=~np.isnan(heights), initial=0)
        if largest > MOST_LENGTH:
            raise WrongSurface(f"has heights of up to {largest:g} mm; allowed are numbers up to {MOST_LENGTH:g} mm, and nan for missing points")
        if np.isnan(heights).all():
            raise WrongSurface("has no measured point; allowed are heights of which some are no nan")
        ends = (heights.shape[1] - (not periodic), heights.shape[0] - (not periodic))
        return cls(heights, dx, dy, -dx * ends[0] / 2, -dy * ends[1] / 2, periodic)

    @property
    def places(self):
        """((nx,), (ny,)): x of the columns and y of the rows, mm."""
        ny, nx = self.heights.shape
        return self.x0 + self.dx * np.arange(nx), self.y0 + self.dy * np.arange(ny)

    @property
    def size(self):
        """(along x, along y), mm: from the first to the last point, or of the period."""
        ny, nx = self.heights.shape
        return (nx - (not self.periodic)) * self.dx, (ny - (not self.periodic)) * self.dy

    @property
    def n_missing(self):
        return int(np.isnan(self.heights).sum())

    def with_heights(self, heights):
        return dataclasses.replace(self, heights=heights)


def check_size(nx, ny):
    """Before memory is taken: raises WrongSurface unless a grid of nx * ny points is a surface of bearable size."""
    if nx < 2 or ny < 2:
        raise WrongSurface(f"has {nx} x {ny} points; allowed are at least 2 along x and y, because a profile is no surface")
    if nx * ny > MOST_POINTS:
        raise WrongSurface(f"has {nx} x {ny} points; allowed are {MOST_POINTS} in all: cut or thin it out in the program of the instrument")


def unit_of(word):
    """mm in a unit such as 'um'. Raises WrongSurface."""
    if word.strip() not in MILLIMETRES:
        raise WrongSurface(f"'{word}': allowed is a unit, one of {', '.join(MILLIMETRES)}")
    return MILLIMETRES[word.strip()]


def length_of(text):
    """mm of a number with or without a unit behind it: '0.5 um', '0.0005'. Raises WrongSurface."""
    number = text.strip().rstrip("".join(MILLIMETRES)).strip()
    unit = text.strip()[len(number):].strip()
    try:
        value = float(number) * unit_of(unit or "mm")
    except ValueError:
        value = math.nan
    if not abs(value) <= MOST_LENGTH:
        raise WrongSurface(f"'{text}': allowed is a length in mm or with a unit ({', '.join(MILLIMETRES)}), such as 0.5um, up to "
                           f"{MOST_LENGTH:g} mm")
    return value
