# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Rows of the book: half-spaces on regular grids, without a mesh."""
import math

import numpy as np

import answers
from answers import YOUNG, Sphere
from measure import circle_of, fitted_ellipse, gyration, left_by_slip, normal, of_history
from row import Row, Scene
from sheared import legs_of_spence, spence_middle, spence_stick

PATCHES, EXACT = "128 x 128 patches", "exact for nu = 0: (a/R)²"


def on_grid(file, size_x, size_y=None, cells="128, 128"):
    """A scene of prm/verification with a half-space in place of its body."""
    return Scene(file, ("Geometry/Shape=half-space", f"Geometry/Sizes={size_x:g}, {size_y or size_x:g}", f"Mesh/Cells={cells}"))


FINER = [(f"Mesh/Cells={n}, {n}",) for n in (48, 96, 192)]  # three grids, each twice as fine as the one before


BALL, ON_PLATE = Scene("ball_on_plate"), Sphere(175, 100, 0, 0.3, (YOUNG, 0))


def pulled(angle):
    """Under 17.5 N along an angle (degrees)."""
    along, across = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    legs = " ".join(f"{name} {17.5 * part:.9g}" for name, part in (("Fx", along), ("Fy", across)) if abs(part) > 1e-9)
    mu = 1 / math.hypot(along / 0.3, across / 0.15)
    return Row(f"grid.ball.{angle}", BALL.set(f"Load program/Legs={legs} : 4"), f"radius that sticks, pulled along {angle}° (mm)",
               circle_of(left_by_slip(mu, angle), 5), Sphere(175, 100, 0, mu, (YOUNG, 0)).stick_radius(17.5), 0.001,
               "Cattaneo 1938, mu along the force", EXACT)


ELLIPTIC = on_grid("elliptic_hertz", 3.2, 1.6)
ELLIPSE = answers.elliptic_hertz(1000, answers.plane_modulus((YOUNG, 0.3)), 400, 100)


def of_ellipse(x, y):
    return (x / ELLIPSE[0])**2 + (y / ELLIPSE[1])**2 < 0.7


def semi_axis(index):
    return lambda runs, scene: math.sqrt(5) * float(gyration(runs(scene), 1, normal)[index])


BELOW, STEEL = answers.deepest_shear(0.3), Sphere(384.615)
INSIDE = on_grid("hertz", 1.2).set("Output/Lines=axis: 0 0 0 to 0 0 0.5, 251", "Output/Line fields=4")


def beneath(index):
    """A measure: largest shear on the axis, by p0 (0), and its depth, by a (1)."""
    def measured(runs, scene):
        line = runs(scene).line("axis", 4)
        shear = np.abs(line["stress_zz"] - line["stress_xx"]) / 2
        deepest = int(np.argmax(shear))
        return (shear[deepest] / STEEL.largest_pressure, line["z"][deepest] / STEEL.contact_radius)[index]
    return measured


EQUAL, SOFT = on_grid("equal_spheres", 2.4), Sphere(9.1954, 50, 0.42, 0.4, (568, 0.42), 568)
PULL = 3.21839  # N
SPENCE = on_grid("spence", 8)
FINE_SPENCE = SPENCE.set(legs_of_spence(280), "Output/Contact fields=280")

CLOSING = math.pi * answers.plane_modulus((YOUNG, 0.3)) * 0.001  # MPa, of the wavy surface
WAVY = Scene("wavy_surface")
SQUEEZED = 0.001 + 1.5 * CLOSING * 1.3 * 0.4 / (0.7 * YOUNG)


def half_width(step):
    """A measure: of the strips, to half a patch."""
    return lambda runs, scene: float(runs(scene).history["contact_area"][step - 1]) / 0.03125 / 2


GRIDS = (
    Row("grid.ball.a", BALL, "contact radius (mm)", circle_of(normal, 5), ON_PLATE.contact_radius, 0.001, "Hertz", EXACT),
    Row("grid.ball.p0", BALL, "largest pressure (MPa)", of_history("max_pressure", 5), ON_PLATE.largest_pressure, 0.001, "Hertz",
        EXACT, meshes=FINER, order=1.5),
    Row("grid.ball.approach", BALL, "approach (mm)", of_history("uz", 5, -1), ON_PLATE.approach, 0.001, "Hertz", EXACT,
        meshes=FINER, order=1.5),
    *(pulled(angle) for angle in (0, 45, 90)),
    Row("grid.elliptic.a", ELLIPTIC, "semi-axis along x (mm)", semi_axis(0), ELLIPSE[0], 0.002, "Hertz", "half-space: (a/R)²"),
    Row("grid.elliptic.b", ELLIPTIC, "semi-axis along y (mm)", semi_axis(1), ELLIPSE[1], 0.002, "Hertz", "half-space: (a/R)²"),
    Row("grid.elliptic.p0", ELLIPTIC, "largest pressure (MPa)",
        lambda runs, scene: fitted_ellipse(runs(scene).contact(1), of_ellipse)[2], ELLIPSE[2], 0.002, "Hertz",
        "half-space: (a/R)²"),
    Row("grid.elliptic.approach", ELLIPTIC, "approach (mm)", of_history("uz", 1, -1), ELLIPSE[3], 0.002, "Hertz",
        "half-space: (a/R)²"),
    Row("grid.hertz.shear", INSIDE, "largest shear below the surface, by p0", beneath(0), BELOW[0], 0.001, "Huber 1904",
        "half-space: (a/R)²"),
    Row("grid.hertz.depth", INSIDE, "its depth, by a", beneath(1), BELOW[1], 0.005, "Huber 1904", "line of 2 µm"),
    Row("grid.equal.approach", EQUAL, "approach (mm)", of_history("uz", 1, -1), SOFT.approach, 0.001, "Hertz",
        "half-space: (a/R)²", "CONTACT 0.02"),
    Row("grid.equal.c", EQUAL, "radius that sticks at 7/8 of sliding (mm)", circle_of(left_by_slip(0.4, 0), 5),
        SOFT.stick_radius(PULL), 0.03, "Cattaneo 1938", "slip not quite along the traction: 1 to 3 %", "CONTACT 0.5"),
    Row("grid.equal.shift", EQUAL, "shift (mm)", of_history("ux", 5), SOFT.shift(PULL), 0.005, "Mindlin 1949",
        "slip not quite along the traction", "CONTACT 0.008155 (19 x 19 elements)"),
    Row("grid.spence.c", FINE_SPENCE, "c/a, 280 load steps", spence_stick(280), 0.5, 0.01, "Spence 1975", PATCHES, "CONTACT 0.5"),
    Row("grid.spence.p0", FINE_SPENCE, "pressure in the middle, by Hertz", spence_middle(280), 1.31, 0.005, "Spence 1975",
        "printed to three digits", "CONTACT 1.31"),
    Row("grid.spence.35", SPENCE, "approach at P = (35/45)³ (mm)", of_history("uz", 35, -1), 0.09874, 0.003, "CONTACT",
        "printed to four digits", "CONTACT 0.09874"),
    Row("grid.wavy.a", WAVY, "half width of the strips at p*/2 (mm)", half_width(2), 0.25, 0.002, "Westergaard 1939",
        "exact: periodic"),
    Row("grid.wavy.p0", WAVY, "largest pressure at p*/2 (MPa)", of_history("max_pressure", 2), math.sqrt(2) * CLOSING, 0.001,
        "Westergaard 1939", "exact: periodic"),
    Row("grid.wavy.squeezed", WAVY, "approach at 3/2 p* (mm)", of_history("uz", 4, -1), SQUEEZED, 1e-8,
        "amplitude and layer", "exact: periodic"),
)
