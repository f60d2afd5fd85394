# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Rows of the book: spheres with friction, pressed, sheared and twisted."""
import math

import numpy as np

from answers import Sphere
from measure import circle_of, end_of_stick, left_by_slip, of_history, on_surface
from row import Row, Scene

CATTANEO = "slip not quite along the traction: 1 to 3 %"

# Cattaneo and Mindlin, on a rigid plane.
SHEARED, SPHERE, Q = Scene("cattaneo_mindlin"), Sphere(466.6, poisson=0.4999), 83.99  # N


def shift_on_half_space(sphere, shear, step):
    """A measure: the shift of the body at a step, less that of the same body stuck, plus that of a stuck patch: a difference,
    because theory knows nothing of the body far from the contact."""
    def measured(runs, scene):
        stuck = runs(scene.set("Friction/Coefficients=100, 100", f"Load program/Legs=Fx {shear} : 1"))
        return float(runs(scene).history["ux"][step - 1] - stuck.history["ux"][-1]) + sphere.stuck_shift(shear)
    return measured


def dissipation(first, last):
    """A measure: what the steps from first to last dissipate."""
    return lambda runs, scene: float(np.sum(runs(scene).history["dissipation"][first - 1:last]))


MINDLIN = (
    Row("mindlin.c", SHEARED, "radius that sticks at Q (mm)", circle_of(left_by_slip(0.3, 0), 10), SPHERE.stick_radius(Q), 0.01,
        "Cattaneo 1938", CATTANEO),
    Row("mindlin.reversed", SHEARED, "the same at -Q (mm)", circle_of(left_by_slip(0.3, 0, -1), 22), SPHERE.stick_radius(Q),
        0.01, "Mindlin and Deresiewicz 1953", CATTANEO),
    Row("mindlin.shift", SHEARED, "shift at Q, but for the body's own (mm)", shift_on_half_space(SPHERE, Q, 10),
        SPHERE.shift(Q), 0.01, "Mindlin 1949", CATTANEO),
    Row("mindlin.loop", SHEARED, "dissipation of a cycle (N mm)", dissipation(11, 34), SPHERE.loop_area(Q), 0.02,
        "Mindlin and Deresiewicz 1953", CATTANEO),
)

# CONTACT's example: both bodies of one material.
EQUAL, SOFT_SPHERE, PULL = Scene("equal_spheres"), Sphere(9.1954, 50, 0.42, 0.4, (568, 0.42), 568), 3.21839
EXAMPLE = (
    Row("equal.a", EQUAL, "contact radius (mm)", circle_of(lambda force: force[:, 2], 1), SOFT_SPHERE.contact_radius, 0.005,
        "Hertz", "half-space: (a/R)²"),
    Row("equal.approach", EQUAL, "approach (mm)", of_history("uz", 1, -1), SOFT_SPHERE.approach, 0.003, "Hertz",
        "one body has an end: 0.1 %", "CONTACT 0.02"),
    Row("equal.c", EQUAL, "radius that sticks at 7/8 of sliding (mm)", circle_of(left_by_slip(0.4, 0), 5),
        SOFT_SPHERE.stick_radius(PULL), 0.03, "Cattaneo 1938", CATTANEO, "CONTACT 0.5"),
    Row("equal.shift", EQUAL, "shift, but for the body's own (mm)", shift_on_half_space(SOFT_SPHERE, PULL, 5),
        SOFT_SPHERE.shift(PULL), 0.02, "Mindlin 1949", CATTANEO + "; contact radius to a node: 1 %", "CONTACT 0.008155 (19 x 19 elements)"),
)


# Orthotropic friction, nu = 0, where normal, tangential and both tangential directions do not couple.
def orthotropic(angle):
    """Scene and answer for 17.5 N along an angle (degrees)."""
    along, across = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    legs = " ".join(f"{name} {17.5 * part:.9g}" for name, part in (("Fx", along), ("Fy", across)) if abs(part) > 1e-9)
    mu = 1 / math.hypot(along / 0.3, across / 0.15)
    scene = Scene("orthotropic_sphere", (f"Load program/Legs={legs} : 4",))
    row = Row(f"orthotropic.{angle}", scene, f"radius that sticks, pulled along {angle}° (mm)", circle_of(left_by_slip(mu, angle), 5),
              Sphere(175, 100, 0, mu, (210000, 0)).stick_radius(17.5), 0.01, "Cattaneo 1938, mu along the force",
              "exact for nu = 0: (a/R)²")
    return row


ORTHOTROPIC = tuple(orthotropic(angle) for angle in (0, 45, 90))

# Lubkin's torsion.
TWISTED, MU, FORCE = Scene("pressed_sphere_in_torsion"), 0.3, 466.6
A, G = SPHERE.contact_radius, SPHERE.shear_modulus
OF_BODY = 10 / (G * math.pi / 2 * 10**4)  # H / (G J), with the height that the head comment has


def rotation(step):
    """Of the contact, radians: that of the top less that of the body."""
    def measured(runs, scene):
        history = runs(scene).history
        return math.radians(history["rz"][step - 1]) + OF_BODY * history["moment_z"][step - 1]
    return measured


def stiffness(runs, scene):
    """N mm."""
    return -float(runs(scene).history["moment_z"][-1]) / rotation(len(runs(scene).history["rz"]))(runs, scene)


def twice(c):
    """Scene that twists back and forth to the moment of c / a."""
    moment = f"{SPHERE.moment(c):.8g}"
    return TWISTED.set(f"Load program/Legs=Mz {moment} : 4 ; Mz -{moment} : 16 ; Mz {moment} : 16")


TORSION = (
    *(Row(f"torsion.{c}", TWISTED, f"rotation at c/a = {c} (rad)", rotation(step), SPHERE.rotation(c), 0.005, "Lubkin 1951",
          "half-space: (a/R)²") for c, step in ((0.9, 4), (0.7, 7), (0.5, 10))),
    Row("torsion.loop", TWISTED, "dissipation of a cycle, c/a = 0.5 (N mm)", dissipation(11, 42), SPHERE.loop_of_torsion(0.5),
        0.01, "Deresiewicz 1954, by Masing's rule", "half-space: (a/R)²"),
    Row("torsion.small", twice(0.8), "dissipation of a cycle, c/a = 0.8 (N mm)", dissipation(7, 38),
        SPHERE.loop_of_torsion(0.8), 0.01, "Deresiewicz 1954, by Masing's rule", "half-space: (a/R)²"),
    Row("torsion.stuck", TWISTED.set("Friction/Coefficients=100, 100", "Load program/Legs=Mz 10 : 1"),
        "stiffness of the stuck contact (N mm)", stiffness, 16 / 3 * G * A**3, 0.03, "Reissner and Sagoci 1944",
        "contact radius to a node: 5 %"),
    Row("torsion.sliding", TWISTED.set("Load program/Legs=rz 0.5 : 6"), "moment of full slip (N mm)",
        of_history("moment_z", -1, -1), 3 * math.pi / 16 * MU * FORCE * A, 0.001, "Lubkin 1951", "half-space: (a/R)²"),
)


# Spence: pressed with friction, which slip from the rim inwards uses up.
def legs_of_spence(steps, last=35):
    """P = (k / 45)^3 at evenly spaced k up to `last`, with so many steps."""
    return "Load program/Legs=" + " ; ".join(f"Fz -{(last * k / steps / 45)**3:.10g} : 1" for k in range(1, steps + 1))


SPENCE = Scene("spence")
FINE_SPENCE = SPENCE.set(legs_of_spence(280), "Output/Contact fields=280")
SELF_SIMILAR, FORCE_OF_35 = "half-space: (a/R)²", (35 / 45)**3  # N


def spence_stick(step):
    """A measure: c / a, where the friction criterion comes to 0, over the rim of the contact."""
    def measured(runs, scene):
        run = runs(scene)
        radius, criterion = on_surface(run, step, "friction_criterion")
        sticks = on_surface(run, step, "status")[1] == 1
        return end_of_stick(radius, criterion, sticks) / spence_rim(run, step)
    return measured


def spence_rim(run, step):
    """Contact radius: from where pressure falls like a root, its squares at the outer third go on to 0."""
    radius, pressure = on_surface(run, step, "pressure")
    rim = radius[pressure > 0].max()
    outer = (pressure > 0) & (radius > 0.65 * rim)
    return math.sqrt(max(np.roots(np.polyfit(radius[outer]**2, pressure[outer]**2, 2)).real, key=lambda x: -abs(x - rim**2)))


def spence_middle(step):
    """A measure: pressure in the middle by that of Hertz."""
    def measured(runs, scene):
        run = runs(scene)
        hertz = Sphere(float(run.history["force_z"][step - 1]), 1 / (2 * 0.004116), 0, young=1)
        return float(on_surface(run, step, "pressure")[1][0]) / hertz.largest_pressure
    return measured


SELF = (
    Row("spence.c", FINE_SPENCE, "c/a, 280 load steps", spence_stick(280), 0.5, 0.003, "Spence 1975", SELF_SIMILAR, "CONTACT 0.5"),
    Row("spence.p0", FINE_SPENCE, "pressure in the middle, by Hertz", spence_middle(280), 1.31, 0.004, "Spence 1975",
        "printed to three digits", "CONTACT 1.31"),
    Row("spence.15", SPENCE, "approach at P = (15/45)³ (mm)", of_history("uz", 15, -1), 0.01811, 0.003, "CONTACT",
        "printed to four digits", "CONTACT 0.01811"),
    Row("spence.35", SPENCE, "approach at P = (35/45)³ (mm)", of_history("uz", 35, -1), 0.09874, 0.003, "CONTACT",
        "printed to four digits", "CONTACT 0.09874"),
    Row("spence.energy", SPENCE, "elastic energy at the end (N mm)", of_history("elastic_energy", 35), 0.01847, 0.003, "CONTACT",
        "printed to four digits", "CONTACT 0.01847"),
)

ROWS = (*MINDLIN, *EXAMPLE, *ORTHOTROPIC, *TORSION, *SELF)
