# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Loads that are not allowed: name of the file, its text without the message, the message."""
FOLDER = "values"
BOX = "subsection Geometry\n  set Shape = box\nend\n"
NAME = "a name of letters, digits and '-' before ':', which begins with a letter"
KIND = "a kind of load behind the name, of pressure, traction, motion, force, temperature, interference"
ALONG = "'along' with x, y, z, -x, -y, -z, or with three numbers 'a, b, c' that are not all 0"
TAKEN = "a name that legs and tables do not use otherwise, as they use '{}'"
SIDES = "x-, x+, y-, y+"


def form(name, loads, allowed):
    """A row on the text of the entry."""
    return (f"load_{name}", f"{BOX}subsection Load program\n  set Loads = {loads}\n  set Legs = a 1 : 1\nend\n",
            f"{{file}}:6: Load program/Loads = {loads}: allowed is {allowed}")


def scene(name, load, fault, before=BOX):
    """A row on a load that does not fit the scene."""
    return (f"load_{name}", f"{before}subsection Load program\n  set Loads = {load}\n  set Legs = a 1 : 1\nend\n",
            f"{{file}}: Load program/Loads: '{load}'{fault}")


ROWS = [
    form("without_colon", "a pressure on x+", 'nothing, or loads "NAME: KIND on SURFACE" or "NAME: KIND on SURFACE along '
         'x", separated by \';\', where KIND is one of pressure, traction, motion, force, temperature, interference'),
    form("without_kind", "a: on x+", KIND),
    form("of_unknown_kind", "a: presure on x+", KIND),
    form("without_name", ": pressure on x+", NAME),
    form("of_two_words", "bulk stress: pressure on x+", NAME),
    form("named_by_a_number", "1: pressure on x+", NAME),
    form("named_like_a_suffix", "a_u: pressure on x+", NAME),
    form("named_like_a_component", "Fx: pressure on x+", TAKEN.format("Fx")),
    form("named_like_a_column", "time: pressure on x+", TAKEN.format("time")),
    form("named_twice", "a: pressure on x+ ; a: pressure on x-", "each name once; 'a' is there twice"),
    form("without_surface", "a: pressure", "'pressure on SURFACE'"),
    form("surface_twice", "a: pressure on x+ x+",
         "surfaces behind 'on', each once, with 'lower' in front of those of the second body"),
    form("pressure_along", "a: pressure on x+ along x", "'pressure' without 'along'"),
    form("traction_without_direction", "a: traction on x+", "'traction on SURFACE along x', with x, y, z or three numbers"),
    form("along_w", "a: traction on x+ along w", ALONG),
    form("along_nothing", "a: traction on x+ along 0, 0, 0", ALONG),
    form("along_two_numbers", "a: traction on x+ along 1, 2", ALONG),
    form("motion_askew", "a: motion on x+ along 1, 1, 0", "'motion on SURFACE along x', y or z"),
    form("warm_surface", "a: temperature on x+", "'temperature' without a surface, or 'temperature on lower'"),
    scene("on_base", "a: pressure on base",
          f" acts on the contact surface, where the counterface alone may: allowed are {SIDES}"),
    scene("on_held_face", "a: pressure on top", " acts on the held face, which Geometry/Top face = clamped moves as a rigid "
          f"plate: allowed are {SIDES}"),
    scene("of_a_cylinder", "a: pressure on side", f": side is no surface of Geometry/Shape = box: allowed are {SIDES}"),
    scene("across_plane_strain", "a: pressure on y+", ": y+ is no surface of Geometry/Shape = box in plane strain: allowed "
          "are x-, x+", "subsection Geometry\n  set Shape = box\n  set Kind = plane strain\nend\n"),
    scene("on_no_lower_body", "a: pressure on lower x+",
          " with Obstacle/Kind = rigid: allowed on lower is Kind = body, which has a lower body"),
    scene("without_expansion", "a: temperature",
          " with Material/Thermal expansion = 0 does nothing: allowed is a number other than 0"),
    ("load_misspelt", "subsection Load program\n  set Loads = bulk: pressure on side\n  set Legs = bulg 1 : 1\nend\n",
     "{file}:4: Load program/Legs = bulg 1 : 1: allowed is a name of ux, uy, uz, rx, ry, rz, Fx, Fy, Fz, Mx, My, Mz, bulk; "
     "'bulg' is none, is bulk meant?"),
    ("load_twice_in_a_leg",
     "subsection Load program\n  set Loads = bulk: pressure on side\n  set Legs = bulk 1 bulk 2 : 1\nend\n",
     "{file}:4: Load program/Legs = bulk 1 bulk 2 : 1: allowed is a load once in a leg; bulk is named twice"),
    ("load_of_one_side", f"{BOX}subsection Mesh\n  set Model = quarter\nend\nsubsection Load program\n  set Loads = a: "
     "pressure on x+\n  set Legs = a 1 : 1\nend\n",
     "{file}: Mesh/Model = quarter is not possible: Load program/Loads: a acts on x+ and not on x-; possible models are "
     "full, half"),
    ("load_sideways_in_a_section", "subsection Mesh\n  set Model = axisymmetric\nend\nsubsection Friction\n  set Coefficients "
     "= 0.1, 0.1\nend\nsubsection Load program\n  set Loads = a: traction on side along x\n  set Legs = a 1 : 1\nend\n",
     "{file}: Mesh/Model = axisymmetric is not possible: Load program/Loads: a acts along x; possible models are full, half"),
    ("load_force_in_problems", "subsection Load program\n  set Loads = a: force on side along z\n  set Legs = a -1 : 1\nend\n"
     "subsection Output\n  set Problems = 1\nend\n",
     "{file}: Output/Problems with Load program/Loads = 'a: force on side along z': FCLIB's format has no place for the "
     "stiffness of the body against the motion of that surface; allowed are motions, or Problems = 0"),
    ("load_moves_an_edge_twice", f"{BOX}subsection Load program\n  set Loads = a: motion on x+ along z ; b: force on y+ along "
     "z\n  set Legs = uz -0.01 a -0.01 b 1 : 1\nend\n",
     "{file}: Load program/Loads: a and b along z move the same nodes: allowed are surfaces that do not meet, or one load on "
     "both"),
    ("free_top_driven", "subsection Geometry\n  set Top face = free\nend\n",
     "{file}: Load program/Legs: uz in leg 1 with Geometry/Top face = free, so that there is no held face to drive: "
     "allowed are names of Load program/Loads, or Top face = clamped"),
    ("free_top_of_lower", "subsection Obstacle\n  set Kind = body\nend\nsubsection Lower geometry\n  set Top face = free\nend\n",
     "{file}: Lower geometry/Supports leave the quarter model free to move along z: allowed are supports that hold it, or Top "
     "face = clamped"),
]
