# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Rows of the book: whole bodies that stick, slide, wear or are squeezed."""
import math

import numpy as np

from answers import gross_sliding
from measure import of_history
from row import Row, Scene

EXACT = "exact"

# Uniform states.
FIT = Scene("press_fit")
PUSHED_OUT = FIT.set("Geometry/Top face=guided", "Geometry/Supports=", "Material/Poisson ratio=0",
                     "Load program/Legs=fit 1 : 1 ; uz -0.2 : 4")
LAME = 210000 / (1.3 * 0.4) * 0.01 / 10
PATCH, BOX, SHAFT, RIM = Scene("patch_test"), Scene("box"), Scene("torsion"), Scene("first_slip_in_torsion")
FULL = ("Mesh/Model=full",)
COARSE_RIM = tuple((f"Mesh/Core cells={n}", f"Mesh/Rings={n}", *FULL) for n in (2, 4, 8))


def rim_angle(runs, scene):
    """Angle of the first slip, degrees: the friction criterion grows with the angle."""
    return 0.03 / (1 + float(runs(scene).contact(2)["friction_criterion"].max()))


UNIFORM = (
    Row("patch.least", PATCH, "least pressure (MPa)", of_history("min_pressure"), 2100, 1e-6, "E u / H", EXACT),
    Row("patch.largest", PATCH, "largest pressure (MPa)", of_history("max_pressure"), 2100, 1e-6, "E u / H", EXACT),
    Row("patch.slip", PATCH, "slip at the rim (mm)", of_history("max_slip"), 0.03, 1e-6, "nu u R / H", EXACT),
    Row("box.pressure", BOX, "largest pressure (MPa)", of_history("max_pressure"), 1000, 1e-8, "F / A", EXACT),
    Row("box.motion", BOX, "motion of the top (mm)", of_history("uz"), -8 / 210, 1e-8, "F l / (E A)", EXACT),
    Row("box.slip", BOX, "slip at the corner (mm)", of_history("max_slip"), 0.3 / 210 * math.hypot(10, 6), 1e-8, "nu u_z / l_z r",
        EXACT),
    Row("shaft.moment", SHAFT, "moment of a shaft that sticks (N mm)", of_history("moment_z"),
        -105000 * math.pi / 2 * 1e4 * math.radians(0.5) / 10, 1e-8, "Saint-Venant", EXACT),
    Row("shaft.slip", RIM, "angle of the first slip (degrees)", rim_angle, math.degrees(6e-4), 1e-3, "mu p H / (G R)", EXACT),
    Row("shaft.solid", RIM.set(*COARSE_RIM[2]), "the same in the full model (degrees)", rim_angle, math.degrees(6e-4), 2e-3,
        "mu p H / (G R)", "facets of the rim", meshes=COARSE_RIM, order=1.5),
    Row("fit.least", FIT, "least pressure of a shaft in a narrow bore (MPa)", of_history("min_pressure"), LAME, 1e-9, "Lamé", EXACT),
    Row("fit.largest", FIT, "largest pressure (MPa)", of_history("max_pressure"), LAME, 1e-9, "Lamé", EXACT),
    Row("fit.quarter", FIT.set("Mesh/Model=quarter"), "the same of a quarter with 16 cells around (MPa)",
        of_history("max_pressure"), LAME, 1e-8, "Lamé", EXACT),
    Row("fit.pushed", PUSHED_OUT, "force along the axis that pushes it out, nu = 0 (N)", of_history("force_z"),
        0.1 * 2 * math.pi * 10 * 10 * 210, 1e-8, "mu p 2 pi R L", EXACT),
)

# Sliding.
DIRECTIONS = (15, 45, 75, 130, 200, 290)


def sliding(p):
    """A measure: largest difference of force / normal force from the closed form, over bodies dragged along DIRECTIONS."""
    def measured(runs, scene):
        found = []
        for angle in map(math.radians, DIRECTIONS):
            legs = f"0 0 -0.01 : 1 ; {100 * math.cos(angle):.15g} {100 * math.sin(angle):.15g} -0.01 : 8"
            history = runs(scene.set(f"Load program/Legs={legs}")).history
            force = np.array([history["force_x"][-1], history["force_y"][-1]]) / history["force_z"][-1]
            found.append(np.abs(force - gross_sliding((0.8, 0.4), p, angle)).max())
        return float(max(found))
    return measured


def slides(p):
    return Scene("gross_sliding", (f"Friction/Slip potential={p[0]}, {p[1]}",))


BY_FORCE = Scene("gross_sliding_by_force")
OF_45 = gross_sliding((0.8, 0.4), (0.8, 0.4), math.pi / 4)

# The wedge: its weight presses it on a plane inclined by tan a = 0.1, and a level force pushes it up.
WEIGHT, SLOPE, MU = 1000, math.atan(0.1), 0.2
LIMIT = WEIGHT * (0.1 + MU) / (1 - MU * 0.1)


def on_slope(push):
    """Forces across and along the plane, N."""
    return (-(WEIGHT * math.cos(SLOPE) + push * math.sin(SLOPE)), push * math.cos(SLOPE) - WEIGHT * math.sin(SLOPE))


def push_up(runs, scene):
    """Last push that found an equilibrium, by the weight: from the forces of the last step that was solved."""
    history = runs(scene).history
    across, along = history["held_force_z"][-1], history["held_force_x"][-1]
    return float(along * math.cos(SLOPE) - across * math.sin(SLOPE)) / WEIGHT


WEDGE = Scene("wedge", code=3)


def by_force_z(component):
    """A measure: a force at the end against the force along z."""
    def measured(runs, scene):
        history = runs(scene).history
        return float(-history[f"force_{component}"][-1] / history["force_z"][-1])
    return measured


MOVING = (
    *(Row(f"sliding.{name}", slides(p), f"force by normal force, {name}, largest difference over six directions", sliding(p), 0,
          1e-9, "the slip rule", EXACT, scale=1)
      for name, p in (("associated", (0.8, 0.4)), ("collinear", (1, 1)), ("steeper", (0.2, 0.7)))),
    Row("sliding.force_x", BY_FORCE, "force along x under 10 kN, pulled along 45° (N)", of_history("force_x"), 1e4 * OF_45[0], 1e-6,
        "the slip rule", EXACT),
    Row("sliding.force_y", BY_FORCE, "force along y (N)", of_history("force_y"), 1e4 * OF_45[1], 1e-6, "the slip rule", EXACT),
    Row("wedge.push", WEDGE, "push that slides a wedge up, by its weight", push_up, LIMIT / WEIGHT, 2e-4,
        "NAFEMS R0094, CGS-4: (tan a + mu)/(1 - mu tan a)", "steps of 0.02 % of the push"),
    Row("incline.push", Scene("incline"), "the same with the normal of the slope, moved up", by_force_z("x"), LIMIT / WEIGHT, 1e-6,
        "NAFEMS R0094, CGS-4", EXACT),
    Row("groove.pull", Scene("groove"), "pull along a groove, by the force that presses", by_force_z("y"), 0.15 / 0.8, 1e-6,
        "mu / sin(half angle)", EXACT),
)

# The short cylinder between a plate that holds it and one with friction.
SHORT = Scene("short_cylinder")


def squeezed(mu):
    return SHORT.set(f"Friction/Coefficients={mu}, {mu}")


def stiffness(runs, scene):
    """E_app / E: force by that of a bar."""
    history = runs(scene).history
    return float(history["force_z"][-1] / (math.pi * 100 * 210000 * -history["uz"][-1] / 10))


def stick_radius(runs, scene):
    """By R."""
    return math.sqrt(runs(scene).history["stick_area"][-1] / math.pi) / 10


COARSER = ("Mesh/Core cells=8", "Mesh/Rings=8", "Mesh/Layers=8", "Mesh/Rim grading=0.49", "Mesh/Layer grading=0.49")
HALVED = tuple((*COARSER, f"Mesh/Refinements={n}") for n in (0, 1, 2))
RITZ = "Ritz, polynomials up to degree 22, extrapolated"  # upper bounds 1.054336 and 1.118642, which fall with its power 2.8
SQUEEZED = tuple(
    Row(f"squeezed.{mu}", squeezed(mu), f"stiffness by that of a bar, mu = {mu}", stiffness, answer, 2e-5, source, "six digits",
        meshes=HALVED if order else (), order=order)
    for mu, answer, source, order in (
        (0, 1.054304, RITZ, 1), (0.1, 1.07789, "computed, no closed form", 1), (0.2, 1.10223, "computed, no closed form", 0),
        (0.3, 1.11776, "computed, no closed form", 0), (0.5, 1.118578, f"all sticks: {RITZ}", 1)))

# Wear.
WORN, DRAGGED = Scene("worn_sphere"), Scene("worn_punch")
CAP = 1e-3 * 20 * 4 * 13  # mm^3: coefficient x force x way
WEARING = (
    Row("worn.volume", WORN, "worn volume (mm³)", of_history("worn_volume"), CAP, 1e-4, "Archard 1953", EXACT),
    Row("worn.depth", WORN, "depth of the worn cap (mm)", of_history("max_wear_depth"), math.sqrt(CAP / (100 * math.pi)), 0.005,
        "V = pi R h²", "elastic approach: 0.3 %"),
    Row("dragged.volume", DRAGGED, "worn volume (mm³)", of_history("worn_volume"), 40, 1e-4, "Archard 1953", "slip that shear takes"),
    Row("dragged.pressure", DRAGGED, "largest pressure in the end (MPa)", of_history("max_pressure"), 10, 1e-3, "even wear",
        "400 mm of way"),
)

ROWS = (*UNIFORM, *MOVING, *SQUEEZED, *WEARING)
