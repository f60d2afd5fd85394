# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Rows of the book: bodies with loads on surfaces, the fretting-fatigue rig before all."""
import math

import numpy as np

import answers
from answers import Fretted
from measure import normal, on_line
from row import Row, Scene

OPEN, STICK, SLIP = 0, 1, 2

# The fretting-fatigue rig. Its last step has all loads.
THICKNESS, HEIGHT, LAST = 4, 20, 3
ALLOY = (72100, 0.33)
RIG = Scene("fretting_fatigue")
SOURCE, HALF_PLANE = "Nowell and Hills 1987", "half-planes: (a/H)²"


def fretted(radius, mu, shear=155, bulk=100):
    return Fretted(543 / THICKNESS, answers.plane_modulus(ALLOY, ALLOY), radius, mu, shear / THICKNESS, bulk)


def scene_of(pad):
    return RIG.set(f"Friction/Coefficients={pad.mu}, {pad.mu}", f"Obstacle/Gap=x^2/(2*{pad.radius})",
                   f"Load program/Legs=Fx {pad.shear * THICKNESS:g} bulk {pad.bulk:g} : 1")


def graded(cells, layers, growth):
    """Settings of both meshes."""
    return tuple(f"{mesh}/{entry}" for mesh in ("Mesh", "Lower mesh")
                 for entry in (f"Cells={cells}, 1, {layers}", f"Edge grading={growth}", "Layer grading=0.6"))


def from_edge(pad):
    """The pad moved by a, so that the trailing edge is in the middle of the specimen, where the cells are smallest."""
    return scene_of(pad).set(f"Obstacle/Gap=(x-{pad.half_width:.5f})^2/(2*{pad.radius})", "Output/Volume fields=1",
                             *graded(140, 30, 1.13))


def zone(weight):
    """A measure: middle and half width of the half-ellipse along x that has the moments of weight(nodal forces)."""
    def measured(runs, scene):
        contact = runs(scene).contact(LAST)
        x, weights = contact.points[:, 0].astype(float), weight(contact["nodal_force"].astype(float))
        middle = float(weights @ x / np.sum(weights))
        return middle, 2 * math.sqrt(weights @ (x - middle)**2 / np.sum(weights))
    return measured


def sticking(mu):
    """What friction leaves of its limit, against -x: Cattaneo's half-ellipse on the zone that sticks."""
    return zone(lambda force: mu * force[:, 2] + force[:, 0])


def largest_pressure(runs, scene):
    return float(runs(scene).contact(LAST)["pressure"].max())


def along_surface(run):
    """Places x of the specimen's upper face, and its stresses along x and z there, means of the cells that meet."""
    lower = run.contact(LAST, "lower")
    upper = np.abs(lower.points[:, 2]) < 1e-7
    places, node = np.unique(np.round(lower.points[upper, 0].astype(float), 7), return_inverse=True)
    stress = lower["stress"][upper].reshape(-1, 9).astype(float)
    along, across = (np.bincount(node, stress[:, i]) / np.bincount(node) for i in (0, 8))
    return places, along, across


def stress_at_edge(runs, scene):
    """Largest stress of the specimen along x. Outside of the contact it falls as a root, so that a mesh cuts its tip off. On
    the inside it is smooth but for the pressure, which is 0 at the edge: so the parabola through the stress less that along z,
    in the first half of the zone that slips, goes on to the edge."""
    run = runs(scene)
    x, status = on_line(run, LAST, "status")
    touching = x[status != OPEN]
    slipping = x[(status == SLIP) & (x < np.mean(touching))]
    edge, width = touching.min(), slipping.max() - touching.min()
    places, along, across = along_surface(run)
    share = (places - edge) / width
    inside = (share > 0.05) & (share < 0.45)
    return float(np.polynomial.Polynomial.fit(share[inside], (along - across)[inside], 2)(0))


def largest_of_nodes(runs, scene):
    return float(along_surface(runs(scene))[1].max())


def rig(name, radius, mu, **loads):
    pad = fretted(radius, mu, **loads)
    scene, edge = scene_of(pad), from_edge(pad)
    known = f"R = {radius}, mu = {mu}, Q = {pad.shear * THICKNESS:g} N, bulk {pad.bulk:g} MPa"
    return (
        Row(f"{name}.a", scene, f"half width (mm), {known}", lambda runs, scene: zone(normal)(runs, scene)[1], pad.half_width,
            0.005, "Hertz", HALF_PLANE),
        Row(f"{name}.p0", scene, "largest pressure (MPa)", largest_pressure, pad.largest_pressure, 0.005, "Hertz", HALF_PLANE),
        Row(f"{name}.c", scene, "half width that sticks (mm)", lambda runs, scene: sticking(mu)(runs, scene)[1],
            pad.stick(pad.shear), 0.005, SOURCE, HALF_PLANE),
        Row(f"{name}.e", scene, "shift of what sticks (mm)", lambda runs, scene: sticking(mu)(runs, scene)[0], pad.shift, 0.03,
            SOURCE, "half-planes: Q/(2 t H) adds to the bulk stress"),
        Row(f"{name}.stress", edge, "largest stress of the specimen along x (MPa)", stress_at_edge,
            pad.edge_stress + pad.stress_of_height(HEIGHT), 0.01, SOURCE,
            f"half-planes: {pad.edge_stress:.2f}, and {pad.stress_of_height(HEIGHT):.2f} of the height"))


# The stress at nodes next to the edge, on meshes whose smallest cells are 2, 1 and 0.5 micrometres wide.
WIDE = fretted(50, 0.85)
MESHES = tuple(graded(*mesh) for mesh in ((70, 20, 1.25), (100, 25, 1.1775), (140, 30, 1.13)))
AT_NODES = Row("fatigue.nodes", from_edge(WIDE), "largest stress of its nodes (MPa)", largest_of_nodes,
               WIDE.edge_stress + WIDE.stress_of_height(HEIGHT), 0.03, SOURCE, "a mesh cuts its tip off", meshes=MESHES, order=0.5)

# Without the bulk stress, on a half-plane and on meshed specimens of several heights.
UNPULLED = RIG.set("Load program/Loads=", "Load program/Preload=Fz -543 Fx 0 : 2", "Load program/Legs=Fx 155 : 1")
HALF = UNPULLED.set("Obstacle/Kind=half-space", "Obstacle/Young modulus=72100", "Obstacle/Poisson ratio=0.33")


def by_half_plane(measure):
    return lambda runs, scene: measure(runs, scene) / measure(runs, HALF)


def stick_width(runs, scene):
    return sticking(0.85)(runs, scene)[1]


def contact_width(runs, scene):
    return zone(normal)(runs, scene)[1]


ON_HALF_PLANE = (
    Row("unpulled.a", HALF, "half width on a half-plane, no bulk stress (mm)", contact_width, WIDE.half_width, 0.005, "Hertz",
        HALF_PLANE),
    Row("unpulled.p0", HALF, "largest pressure (MPa)", largest_pressure, WIDE.largest_pressure, 0.005, "Hertz", HALF_PLANE),
    Row("unpulled.c", HALF, "half width that sticks (mm)", stick_width, WIDE.stick(WIDE.shear), 0.005, "Cattaneo 1938",
        HALF_PLANE),
    *(Row(f"unpulled.{name}.{height}", UNPULLED.set(f"Lower geometry/Sizes=40, 4, {height}"),
          f"{what} on a specimen {height} mm high, by that on a half-plane", by_half_plane(measure), 1, 0.003, "the half-plane",
          "(a/H)²")
      for height in (10, 20, 40)
      for name, what, measure in (("a", "half width", contact_width), ("p0", "largest pressure", largest_pressure),
                                  ("c", "half width that sticks", stick_width))))

FATIGUE = (*rig("fatigue", 50, 0.85), AT_NODES, *rig("fatigue.narrow", 10, 0.85), *rig("fatigue.rough", 50, 2.0),
           *rig("fatigue.other", 30, 0.6, shear=200, bulk=60), *ON_HALF_PLANE)
