# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Known answers of the elastic half-space, and what is measured of a run to compare with them.

Hertz 1882; Cattaneo 1938; Mindlin 1949; K. L. Johnson, Contact Mechanics, 1985, sections 3.5, 4.2 and 7.2."""
import dataclasses
import math

import numpy as np

YOUNG = 210000  # MPa


@dataclasses.dataclass(frozen=True)
class Sphere:
    """A half-space (MPa) pressed by `force` (N) on a sphere of `radius` (mm), rigid or with a material of its own."""

    force: float
    radius: float = 100
    poisson: float = 0.3
    mu: float = 0.3
    counterface: tuple = ()  # Young's modulus (MPa) and Poisson's ratio of another half-space; (): rigid

    @property
    def plane_modulus(self):
        """E*, of both."""
        bodies = [(YOUNG, self.poisson)] + ([self.counterface] if self.counterface else [])
        return 1 / sum((1 - poisson**2) / young for young, poisson in bodies)

    @property
    def shear_modulus(self):
        return YOUNG / (2 * (1 + self.poisson))

    @property
    def contact_radius(self):
        return (0.75 * self.force * self.radius / self.plane_modulus) ** (1 / 3)

    @property
    def largest_pressure(self):
        return 1.5 * self.force / (math.pi * self.contact_radius**2)

    @property
    def approach(self):
        return self.contact_radius**2 / self.radius

    def pressure(self, r):
        """MPa at distances r (mm) from the axis."""
        return self.largest_pressure * np.sqrt(np.maximum(0, 1 - (r / self.contact_radius) ** 2))

    # Cattaneo and Mindlin; `shear` is the tangential force in N.

    def stick_radius(self, shear):
        return self.contact_radius * (1 - shear / (self.mu * self.force)) ** (1 / 3)

    def traction(self, r, shear):
        """Tangential, MPa, at the first loading."""
        c = self.stick_radius(shear)
        inner = self.mu * self.largest_pressure * c / self.contact_radius * np.sqrt(np.maximum(0, 1 - (r / c) ** 2))
        return self.mu * self.pressure(r) - inner

    def shift(self, shear):
        """Tangential, mm, at the first loading, of what is far from the contact."""
        most = 3 * self.mu * self.force * (2 - self.poisson) / (16 * self.contact_radius * self.shear_modulus)
        return most * (1 - (1 - shear / (self.mu * self.force)) ** (2 / 3))

    def unloading_shift(self, largest, shear):
        """The same on the way back from the largest shear (Mindlin and Deresiewicz 1953)."""
        return self.shift(largest) - 2 * self.shift((largest - shear) / 2)

    def loop_area(self, largest):
        """Dissipation of a cycle between -largest and largest, N mm."""
        q = largest / (self.mu * self.force)
        factor = 0.9 * (self.mu * self.force) ** 2 * (2 - self.poisson) / (self.contact_radius * self.shear_modulus)
        return factor * (1 - (1 - q) ** (5 / 3) - 5 * q / 6 * (1 + (1 - q) ** (2 / 3)))


def punch_pressure(r, force, radius=1.0):
    """Under a flat punch, MPa at r < radius (mm)."""
    return force / (2 * math.pi * radius * np.sqrt(radius**2 - r**2))


def punch_slope(force, inclination, radius=1.0, poisson=0.3):
    """s in the pressures 1 + s x under an inclined punch relative to a level one, 1/mm."""
    approach = force / (2 * YOUNG / (1 - poisson**2) * radius)
    return 2 * inclination / approach


def radius_of_punch(middle, force):
    """Of the punch whose pressure in the middle (MPa) this is, mm: that of a circle which nodes follow roughly."""
    return math.sqrt(force / (2 * math.pi * middle))


def fitted_sphere(r, pressure, most=0.8):
    """Contact radius and largest pressure of the half-ellipsoid through pressures at r: the line through their squares in
    the inner part of the contact."""
    reach = r[pressure > 0].max()
    inner = (r < most * reach) & (pressure > 0)
    slope, square = np.polyfit(r[inner] ** 2, pressure[inner] ** 2, 1)
    return math.sqrt(-square / slope), math.sqrt(square)
