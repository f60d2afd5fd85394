# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Rows of the book: line contact in plane strain."""
import math

import numpy as np

import answers
from answers import YOUNG, Cylinder, RoundedPunch
from measure import (deepest_shear, fitted_circle, fitted_size, largest_difference, left_by_slip, normal, on_line,
                     strip_of)
from row import Row, Scene

E_STAR = answers.plane_modulus((YOUNG, 0.3))
HALF_PLANE = "half-plane: (a/R)²"
THICKNESS, P = 2, 906.2287  # mm, N


def largest_of_line(step):
    return lambda runs, scene: fitted_circle(*on_line(runs(scene), step, "pressure"))[1]


def traction(step, component, exact, reach, scale):
    """A measure: largest difference of the nodal tractions from exact(x) within |x| < reach, by `scale`."""
    def measured(runs, scene):
        x, values = on_line(runs(scene), step, "friction_traction")
        return largest_difference(x, values[:, component], exact, reach) / scale
    return measured


def mean_traction(step, component, exact, reach, scale):
    """The same, root mean square: at the node next to a kink of infinite slope tractions differ by 3 %."""
    def measured(runs, scene):
        x, values = on_line(runs(scene), step, "friction_traction")
        inner = np.abs(x) < reach
        return float(np.sqrt(np.mean((values[inner, component] - exact(x[inner]))**2))) / scale
    return measured


LINE, CYLINDER = Scene("line_contact"), Cylinder(P / THICKNESS, E_STAR)
BLOCK, ROLLER = Scene("roller_on_block"), Cylinder(35000, answers.plane_modulus((YOUNG, 0.3), (70000, 0.3)), 50)


def beneath(index):
    """A measure: largest shear below the contact, by p0 (0), and its depth, by a (1)."""
    def measured(runs, scene):
        shear, depth = deepest_shear(runs(scene), 1, CYLINDER.half_width)
        return (shear / CYLINDER.largest_pressure, depth / CYLINDER.half_width)[index]
    return measured


# A wide body: the mean stress P / W of what is far from the contact adds to the shear, 3 % of it in the file.
INSIDE = LINE.set("Geometry/Sizes=200, 2, 100", "Mesh/Cells=60, 1, 60", "Mesh/Edge grading=1.25", "Mesh/Layer grading=0.8",
                  "Output/Volume fields=1")
BELOW = answers.deepest_shear()

PRESSED = (
    Row("line.a", LINE, "half width (mm)", strip_of(normal, 1), CYLINDER.half_width, 0.003, "Hertz", HALF_PLANE),
    Row("line.p0", LINE, "largest pressure (MPa)", largest_of_line(1), CYLINDER.largest_pressure, 0.003, "Hertz", HALF_PLANE),
    Row("line.shear", INSIDE, "largest shear below the surface, by p0", beneath(0), BELOW[0], 0.01, "Johnson 1985", HALF_PLANE),
    Row("line.depth", INSIDE, "its depth, by a", beneath(1), BELOW[1], 0.01, "Johnson 1985", HALF_PLANE),
    Row("nafems.a", BLOCK, "half width (mm)", strip_of(normal, 1), ROLLER.half_width, 0.003, "NAFEMS R0094, CGS-1: Hertz",
        HALF_PLANE),
    Row("nafems.p0", BLOCK, "largest pressure (MPa)", largest_of_line(1), ROLLER.largest_pressure, 0.003,
        "NAFEMS R0094, CGS-1: Hertz", HALF_PLANE, "code_aster 2 to 6 % off (SSNP154)"),
)

# A flat punch with rounded edges.
ROUNDED, EDGE = Scene("rounded_punch"), RoundedPunch(E_STAR / 2)


def of_punch(x, a):
    return np.array([EDGE.pressure(place, max(a, place * (1 + 1e-9))) for place in x])


def rounded(step, a):
    largest, place = EDGE.largest_pressure(a)
    name = f"rounded.{a}"

    def pressures(runs, scene):
        return on_line(runs(scene), step, "pressure")

    def middle(runs, scene):
        x, pressure = pressures(runs, scene)
        inner = np.abs(x) < 0.3
        return float(np.polyfit(x[inner]**2, pressure[inner], 1)[1])

    def everywhere(runs, scene):
        return largest_difference(*pressures(runs, scene), lambda x: of_punch(np.abs(x), a), 0.98 * a) / largest

    return (Row(f"{name}.a", ROUNDED, f"half width at {EDGE.force(a):.6g} N/mm (mm)",
                lambda runs, scene: fitted_size(*pressures(runs, scene), of_punch, 1.02, 1.1 * a), a, 0.005,
                "Ciavarella, Hills and Monno 1998", HALF_PLANE),
            Row(f"{name}.p", ROUNDED, "pressure in the middle (MPa)", middle, EDGE.pressure(0, a), 0.01,
                "Ciavarella, Hills and Monno 1998", HALF_PLANE),
            Row(f"{name}.largest", ROUNDED, f"largest pressure, at x = {place:.3f} mm (MPa)",
                lambda runs, scene: float(pressures(runs, scene)[1].max()), largest, 0.01,
                "Ciavarella, Hills and Monno 1998", HALF_PLANE),
            Row(f"{name}.field", ROUNDED, "pressure, largest difference within 0.98 a, by the largest", everywhere, 0, 0.02,
                "Ciavarella, Hills and Monno 1998", HALF_PLANE, scale=1))


# Partial slip: along x between two bodies of one material, along y on a rigid plane.
SLIDING, PAIR, ALONG = Scene("cattaneo_line"), Cylinder(P / THICKNESS / 2, E_STAR / 2), 86.998
ACROSS, PULL = Scene("orthotropic_line_contact", ("Mesh/Cells=160, 1, 26", "Mesh/Edge grading=1.05")), 173.9959
EXACT = "exact for any nu: (a/R)²"


def partial_slip(name, scene, cylinder, force, component, limit):
    """Rows of a press, a pull by `force` (N, steps 3 to 6) and its reversal (to step 14)."""
    shear, angle = force / THICKNESS, 90 * component
    peak = 0.3 * cylinder.largest_pressure
    stick = cylinder.stick(shear)
    half_way = 10  # no force: locked-in tractions, that stick in |x| < c of half of the way back
    return (
        Row(f"{name}.c", scene, "half width that sticks (mm)", strip_of(left_by_slip(0.3, angle), 6), stick, 0.01,
            "Cattaneo 1938", limit),
        Row(f"{name}.reversed", scene, "the same after the reversal (mm)", strip_of(left_by_slip(0.3, angle, -1), 14), stick, 0.01,
            "Mindlin and Deresiewicz 1953", limit),
        Row(f"{name}.traction", scene, "traction, largest difference within 0.9 a, by mu p0",
            traction(6, component, lambda x: -cylinder.traction(x, shear), 0.9 * cylinder.half_width, peak), 0, 0.02,
            "Cattaneo 1938", limit, scale=1),
        Row(f"{name}.locked", scene, "where the force is back at 0, root mean square",
            mean_traction(half_way, component, lambda x: -cylinder.unloaded_traction(x, shear, 0), 0.9 * cylinder.half_width, peak),
            0, 0.01, "Mindlin and Deresiewicz 1953", limit, scale=1),
        Row(f"{name}.back", scene, "largest difference after the reversal",
            traction(14, component, lambda x: cylinder.traction(x, shear), 0.9 * cylinder.half_width, peak), 0, 0.02,
            "Mindlin and Deresiewicz 1953", limit, scale=1))


SLIPPING = (*partial_slip("cattaneo", SLIDING, PAIR, ALONG, 0, "exact for equal bodies: (a/R)²"),
            *partial_slip("across", ACROSS, CYLINDER, PULL, 1, EXACT))

ROWS = (*PRESSED, *rounded(1, 1.1), *rounded(2, 1.25), *SLIPPING)
