# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The worst places of a parameter, and the words of a table about them."""
import dataclasses

import numpy as np
from below import Below
from fields import TITLES, UNITS

MOST, SHARE = 3, 0.9  # places of a parameter, and what of its largest value they have
HEAD = f"{'':25}{'value':>11}{'':9}{'of limit':>9}  {'where':12}{'x':>9}{'y':>9}{'z':>9}{'depth':>9}{'inclination':>13}{'towards':>9}"


@dataclasses.dataclass
class Place:
    """One point and what a parameter is there. where: the body or the line. below: a Below of this point. normal: of the critical
    plane, or None. ratio: to the value at the fatigue limit, or None."""
    name: str
    value: float
    ratio: float
    where: str
    below: Below
    normal: np.ndarray

    @property
    def point(self):
        return self.below.points[0]

    @property
    def angles(self):
        """Inclination and azimuth, degrees, or None."""
        return None if self.normal is None else (self.below.inclination(self.normal[None])[0], self.below.azimuth(self.normal[None])[0])


def worst_places(name, parts, apart, most=MOST):
    """The worst places of a parameter, the first one first, that lie `apart` (mm) from each other and have at least the SHARE
    of the largest value, where bodies with different limits are compared by what they have of them. parts: [(where, Below,
    Field)]."""
    values = np.concatenate([field.values for _, _, field in parts])
    points = np.concatenate([below.points for _, below, _ in parts])
    part = np.repeat(np.arange(len(parts)), [len(field.values) for _, _, field in parts])
    first = np.concatenate([[0], np.cumsum([len(field.values) for _, _, field in parts])])
    of_limit = values / np.repeat([field.reference or 1 for _, _, field in parts], [len(field.values) for _, _, field in parts])
    left, found = np.where(np.isfinite(of_limit), of_limit, -np.inf), []
    largest = left.max(initial=-np.inf)
    while len(found) < most and left.max(initial=-np.inf) > 0 and left.max() >= SHARE * largest:
        row = int(np.argmax(left))
        where, below, field = parts[part[row]]
        own = row - first[part[row]]
        normal = None if field.normals is None else field.normals[own]
        ratio = None if field.reference is None else values[row] / field.reference
        found.append(Place(name, values[row], ratio, where, below[own:own + 1], normal))
        left[(part == part[row]) & (np.linalg.norm(points - points[row], axis=1) < apart)] = -np.inf
    return found


def number(value, digits=4):
    """Without a sign at zero."""
    return f"{value:.{digits}g}" if abs(value) > 1e-9 else "0"


def degrees(angle):
    """-180 is 180."""
    if np.isnan(angle):
        return ""
    rounded = round(angle, 1) + 0.0
    return f"{180 if rounded == -180 else rounded:.1f}"


def table_row(place, is_first=True):
    title = TITLES[place.name] if is_first else ""
    ratio = "" if place.ratio is None else f"{place.ratio:.3f}"
    x, y, z = place.point
    angles = ["", ""] if place.angles is None else [degrees(angle) for angle in place.angles]
    return (f"{title:25}{number(place.value):>11} {UNITS[place.name]:8}{ratio:>9}  {place.where[:12]:12}{number(x):>9}{number(y):>9}{number(z):>9}"
            f"{number(place.below.depths[0]):>9}{angles[0]:>13}{angles[1]:>9}").rstrip()


def table(places):
    """Lines of a table. places: {name: [Place]}."""
    lines = [HEAD]
    for name, found in places.items():
        lines += [table_row(place, place is found[0]) for place in found] or [f"{TITLES[name]:25}{'0':>11} {UNITS[name]}".rstrip()]
    return lines
