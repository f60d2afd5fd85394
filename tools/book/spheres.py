# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Rows of the book: bodies pressed without friction, on circles and ellipses."""
import math

import numpy as np

import answers
from answers import YOUNG, Sphere
from measure import (circle_of, deepest_shear, fitted_circle, fitted_ellipse, fitted_size, gyration, largest_difference,
                     normal, of_history, on_surface)
from row import Row, Scene

E_STAR = answers.plane_modulus((YOUNG, 0.3))
HALF_SPACE = "half-space: (a/R)²"
LAYERED = [("Mesh/Core cells=20", "Mesh/Rings=8", "Mesh/Layers=12", "Mesh/Rim grading=1.5625", "Mesh/Layer grading=0.4761"),
           (), ("Mesh/Refinements=1",)]


def largest_of_circle(step):
    return lambda runs, scene: fitted_circle(*on_surface(runs(scene), step, "pressure"))[1]


def size_of_profile(step, profile, guess):
    return lambda runs, scene: fitted_size(*on_surface(runs(scene), step, "pressure"), profile, 0.8 * guess, 1.25 * guess)


def radius_of(column, step):
    """Of the circle whose area is the entry of the history."""
    return lambda runs, scene: math.sqrt(runs(scene).history[column][step - 1] / math.pi)


def approach(step=-1):
    return of_history("uz", step, -1)


# Hertz.
HERTZ, SOFT = Scene("hertz"), Scene("hertz_half_space")
STEEL, ON_SOFT = Sphere(384.615), Sphere(97.675, counterface=(70000, 0.33))
ELLIPTIC = Scene("elliptic_hertz")
ELLIPSE = answers.elliptic_hertz(1000, E_STAR, 400, 100)


def semi_axis(index):
    return lambda runs, scene: math.sqrt(5) * float(gyration(runs(scene), 1, normal)[index])


def of_ellipse(x, y):
    return (x / ELLIPSE[0])**2 + (y / ELLIPSE[1])**2 < 0.7


HERTZIAN = (
    Row("hertz.a", HERTZ, "contact radius (mm)", circle_of(normal, 4), STEEL.contact_radius, 0.003, "Hertz", HALF_SPACE),
    Row("hertz.p0", HERTZ, "largest pressure (MPa)", largest_of_circle(4), STEEL.largest_pressure, 0.003, "Hertz", HALF_SPACE),
    Row("hertz.approach", HERTZ, "approach (mm)", approach(), STEEL.approach, 0.003, "Hertz", "body of 20 a x 40 a: 0.2 %"),
    Row("half-space.a", SOFT, "contact radius (mm)", circle_of(normal, 4), ON_SOFT.contact_radius, 0.005, "Hertz", HALF_SPACE),
    Row("half-space.p0", SOFT, "largest pressure (MPa)", largest_of_circle(4), ON_SOFT.largest_pressure, 0.003, "Hertz",
        HALF_SPACE),
    Row("half-space.approach", SOFT, "approach (mm)", approach(), ON_SOFT.approach, 0.003, "Hertz", "one body has an end: 0.1 %"),
    Row("elliptic.a", ELLIPTIC, "semi-axis along x (mm)", semi_axis(0), ELLIPSE[0], 0.003, "Hertz", HALF_SPACE),
    Row("elliptic.b", ELLIPTIC, "semi-axis along y (mm)", semi_axis(1), ELLIPSE[1], 0.003, "Hertz", HALF_SPACE),
    Row("elliptic.p0", ELLIPTIC, "largest pressure (MPa)",
        lambda runs, scene: fitted_ellipse(runs(scene).contact(1), of_ellipse)[2], ELLIPSE[2], 0.003, "Hertz", HALF_SPACE),
    Row("elliptic.approach", ELLIPTIC, "approach (mm)", approach(), ELLIPSE[3], 0.003, "Hertz", "body of 22 a x 45 a: 0.2 %"),
)

BALLS, OF_BALLS = Scene("two_balls"), Sphere(1641.025641, radius=6, counterface=(YOUNG, 0.3))
TRUE_SHAPES = (
    Row("balls.a", BALLS, "contact radius (mm)", circle_of(normal, 4), OF_BALLS.contact_radius, 0.003, "Hertz", HALF_SPACE),
    Row("balls.p0", BALLS, "largest pressure (MPa)", largest_of_circle(4), OF_BALLS.largest_pressure, 0.005, "Hertz", HALF_SPACE),
)

INSIDE = HERTZ.set("Mesh/Degree=3", "Mesh/Layers=40", "Mesh/Layer grading=0.8", "Output/Volume fields=4")
BELOW = answers.deepest_shear(0.3)


def beneath(index):
    """A measure: largest shear below the contact, by p0 (0), and its depth, by a (1)."""
    def measured(runs, scene):
        shear, depth = deepest_shear(runs(scene), 4, STEEL.contact_radius)
        return (shear / STEEL.largest_pressure, depth / STEEL.contact_radius)[index]
    return measured


INNER = (
    Row("hertz.shear", INSIDE, "largest shear below the surface, by p0", beneath(0), BELOW[0], 0.01, "Huber 1904", HALF_SPACE),
    Row("hertz.depth", INSIDE, "its depth, by a", beneath(1), BELOW[1], 0.01, "Huber 1904", HALF_SPACE),
)

# Other profiles.
CONE, QUARTIC, FLATTENED = Scene("cone"), Scene("quartic"), Scene("truncated_sphere")
CONE_BY_DISTANCE = CONE.set("Obstacle/Gap=0", "Obstacle/Distance=(z + 0.01*sqrt(x^2+y^2))/sqrt(1.0001)")
CONE_RADIUS = math.sqrt(2 * 1000 / (math.pi * E_STAR * 0.01))
QUARTIC_RADIUS = (15 * 1000 / (64 * E_STAR * 1e-4))**0.2
FIRST_FLAT, SECOND_FLAT = (answers.truncated_sphere(force, E_STAR, 10, 0.5) for force in (500, 3000))
PUNCH, TILTED = Scene("flat_punch"), Scene("tilted_punch")


def of_cone(r, a):
    return E_STAR * 0.005 * np.arccosh(np.maximum(1, a / np.maximum(r, 0.02 * a)))


def of_quartic(r, a):
    return 32 * E_STAR * 1e-4 * a**3 / (9 * math.pi) * (2 * (r / a)**2 + 1) * np.sqrt(np.maximum(0, 1 - (r / a)**2))


def punch_pressure(runs, scene):
    """Largest relative difference of the pressures up to 0.85 a."""
    radius, pressure = on_surface(runs(scene), 1, "pressure")
    return largest_difference(radius, pressure / answers.punch_pressure(np.minimum(radius, 0.9), 1000), np.ones_like, 0.85)


def punch_slope(runs, scene):
    """Mean of (p(x) - p(-x)) / (p(x) + p(-x)) / x, which grows as a, for a = 1 mm; a is that of the pressure in the middle."""
    contact = runs(scene).contact(1)
    x, y = contact.points[:, :2].T.astype(float)
    radius = answers.radius_of_punch(contact["pressure"][np.argmin(np.hypot(x, y))], 1000)
    found = []
    for node in np.flatnonzero((np.abs(y) < 1e-6) & (x > 0.05) & (x < 0.8)):
        there, mirrored = contact["pressure"][[node, np.argmin(np.hypot(x + x[node], y))]]
        found.append((there - mirrored) / (there + mirrored) / x[node] / radius)
    return float(np.mean(found))


PROFILES = (
    Row("cone.a", CONE, "contact radius (mm)", size_of_profile(1, of_cone, CONE_RADIUS), CONE_RADIUS, 0.003,
        "Love 1939", HALF_SPACE),
    Row("cone.approach", CONE, "approach (mm)", approach(), math.pi * CONE_RADIUS * 0.005, 0.003, "Love 1939",
        "body of 19 a x 38 a: 0.2 %", meshes=LAYERED, order=1),
    Row("cone.normals", CONE_BY_DISTANCE, "contact radius (mm), cone with its own normals",
        size_of_profile(1, of_cone, CONE_RADIUS), CONE_RADIUS, 0.003, "Love 1939", HALF_SPACE),
    Row("quartic.a", QUARTIC, "contact radius (mm)", size_of_profile(1, of_quartic, QUARTIC_RADIUS), QUARTIC_RADIUS, 0.003,
        "Galin; Sneddon 1965", HALF_SPACE),
    Row("quartic.approach", QUARTIC, "approach (mm)", approach(), 8 / 3 * 1e-4 * QUARTIC_RADIUS**4, 0.003,
        "Galin; Sneddon 1965", "body of 19 a x 38 a: 0.2 %"),
    Row("flattened.approach", FLATTENED, "approach at 500 N (mm)", approach(1), FIRST_FLAT[1], 0.003, "Ejike 1981", HALF_SPACE),
    Row("flattened.more", FLATTENED, "approach at 3 kN (mm)", approach(2), SECOND_FLAT[1], 0.003, "Ejike 1981", HALF_SPACE),
    Row("flattened.a", FLATTENED, "contact radius at 3 kN (mm)", radius_of("contact_area", 2), SECOND_FLAT[0], 0.01,
        "Ejike 1981", "to a node: 1 %"),
    Row("punch.pressure", PUNCH, "pressure, largest difference in r < 0.85 a", punch_pressure, 0, 0.01,
        "Boussinesq", HALF_SPACE, scale=1),
    Row("tilted.slope", TILTED, "slope of the pressure, relative (1/mm)", punch_slope, answers.punch_slope(1000, 1e-4), 0.02,
        "Muskhelishvili 1953; Johnson 1985", "nodes follow the circle to half a cell"),
)

ROWS = (*HERTZIAN, *TRUE_SHAPES, *INNER, *PROFILES)
