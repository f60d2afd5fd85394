# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Rows of the book: bodies with loads on surfaces, the fretting-fatigue rig before all."""
import math

import numpy as np

import answers
from answers import YOUNG, Fretted
from measure import normal, of_history, on_line
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
        Row(f"{name}.e", scene, "shift of the stick zone (mm)", lambda runs, scene: sticking(mu)(runs, scene)[0], pad.shift, 0.03,
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

# The block that is pressed and pushed on a rigid floor.
PUSHED = Scene("pushed_block")
IN_FIVE = PUSHED.set("Load program/Legs=top 50 side 150 : 5")
RAOUS, BY = "Raous; code_aster SSNV128", "computed on 256 contact nodes, no closed form"


def moved(run, step):
    """Distances from the pushed side (mm) and displacements along x (micrometres) of the base."""
    x, motion = on_line(run, step, "displacement")
    return x + 20, 1000 * motion[:, 0]


def at(place):
    return lambda runs, scene: float(np.interp(place, *moved(runs(scene), 1)))


def border(before, behind):
    """A measure: half way between the last node of one status and the first of another."""
    def measured(runs, scene):
        x, status = on_line(runs(scene), 1, "status")
        return float(x[status == before].max() + x[status == behind].min()) / 2 + 20
    return measured


def change_in_five(runs, scene):
    return float(np.abs(moved(runs(scene), 1)[1] - moved(runs(IN_FIVE), 5)[1]).max())


BLOCK = (
    *(Row(f"pushed.{place:g}", PUSHED, f"displacement along x, {place:g} mm from the pushed side (µm)", at(place), known, 0.001,
          RAOUS, BY, f"printed {printed}")
      for place, known, printed in ((0, 28.604, 28.6), (1.25, 27.226, 27.2), (5, 22.868, 22.8), (7.5, 19.808, 19.8),
                                    (11.25, 15.414, "15.0"))),
    Row("pushed.friction", PUSHED, "friction of the floor (N/mm)", of_history("force_x", factor=-1), 1405.36, 1e-4, RAOUS, BY),
    Row("pushed.open", PUSHED, "opens to (mm)", border(OPEN, SLIP), 3.25, 0.05, RAOUS, "to a node: 0.16 mm"),
    Row("pushed.slip", PUSHED, "slips to (mm)", border(SLIP, STICK), 29.7, 0.005, RAOUS, "to a node: 0.16 mm"),
    Row("pushed.steps", PUSHED, "largest difference between one step and five, by the largest displacement", change_in_five, 0,
        1e-6, "the loads are in proportion", scale=28.604))

# The punch with a fillet under pressure, and blocks whose stress is uniform.
PUNCH, BOX = Scene("filleted_punch"), Scene("box")
NAFEMS, MEAN = "NAFEMS R0094, CGS-2", "mean of both printed ones"


def middle(runs, scene):
    """Displacement along z of the middle of the contact, mm."""
    contact = runs(scene).contact(2)
    return float(contact["displacement"][np.hypot(*contact.points[:, :2].T).argmin(), 2])


PRESSED = (
    Row("fillet.0.1", PUNCH, "motion of the middle, mu = 0.1 (mm)", middle, -(0.12858 + 0.13079) / 2, 0.03, NAFEMS, MEAN,
        "code_aster -0.12858 and -0.13079 (SSNA122)"),
    Row("fillet.0", PUNCH.set("Friction/Coefficients=0, 0"), "the same, mu = 0 (mm)", middle, -(0.13073 + 0.13294) / 2, 0.03,
        NAFEMS, MEAN, "code_aster -0.13073 and -0.13294 (SSNA122)"))

CORNER = math.hypot(10, 6)
WARM = BOX.set("Material/Thermal expansion=1.2e-5", "Load program/Loads=warm: temperature", "Load program/Legs=uz 0 warm 100 : 1")
DEEP = BOX.set("Geometry/Top face=free", "Load program/Loads=sea: pressure on top x- x+ y- y+", "Load program/Legs=sea 100 : 1")
UNIFORM = (
    Row("warm.pressure", WARM, "pressure of a block 100 K warmer between rigid plates (MPa)", of_history("max_pressure"),
        YOUNG * 1.2e-3, 1e-8, "E alpha T", "exact"),
    Row("warm.slip", WARM, "slip at its corner (mm)", of_history("max_slip"), 1.3 * 1.2e-3 * CORNER, 1e-8, "(1 + nu) alpha T r",
        "exact"),
    Row("deep.pressure", DEEP, "pressure below a block with 100 MPa all around (MPa)", of_history("min_pressure"), 100, 1e-8, "p",
        "exact"),
    Row("deep.slip", DEEP, "slip at its corner (mm)", of_history("max_slip"), 0.4 * 100 / YOUNG * CORNER, 1e-8,
        "(1 - 2 nu) p r / E", "exact"))

SURFACES = (*BLOCK, *PRESSED, *UNIFORM)
