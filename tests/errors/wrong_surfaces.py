# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Counterfaces, contact surfaces and axes of friction that cannot be: name of the file, its text without the message, the
message."""
FOLDER = "surfaces"


def of_file(mesh, curved="", kind="solid"):
    """A body from a file of the folder `included`, with this entry Curved surfaces."""
    return (f"subsection Geometry\n  set Kind = {kind}\n  set Shape = file\n  set Mesh file = included/{mesh}.msh\n"
            f"  set Contact surface = bore\n  set Held surface = rim\n  set Curved surfaces = {curved}\nend\n")


def sides_of_boxes(gap=0, lower="x-", load="push: pressure on y-"):
    """Two boxes in one place, of which the sides x+ and x- touch."""
    return ("subsection Geometry\n  set Shape = box\n  set Top face = free\n  set Supports = x-: x y z\n  set Contact surface = x+\n"
            "end\nsubsection Lower geometry\n  set Shape = box\n  set Top face = free\n  set Supports = x+: x y z\n"
            f"  set Contact surface = {lower}\nend\nsubsection Obstacle\n  set Kind = body\n  set Normal = surface\n  set Gap = {gap}\n"
            "end\nsubsection Friction\n  set Coefficients = 0.3, 0.3\nend\n"
            f"subsection Load program\n  set Loads = {load}\n  set Legs = {load.split(':')[0]} 1 : 1\nend\n")


ROWS = [
    ("distance_and_gap",
     "subsection Obstacle\n  set Distance = z\n  set Gap = x^2\nend\n",
     "{file}: Obstacle/Distance = z with Obstacle/Gap = x^2: allowed is one of both, because each says where the "
     "counterface is"),
    ("distance_along_normals",
     "subsection Obstacle\n  set Distance = z\n  set Normal = surface\nend\n",
     "{file}: Obstacle/Distance = z with Obstacle/Normal = surface: allowed is Normal = plane, because the gradient "
     "of the distance is the normal"),
    ("gap_of_z",
     "subsection Obstacle\n  set Gap = z\nend\n",
     "{file}: Obstacle/Gap = z contains z, but it is the gap below a place (x, y): allowed is Obstacle/Distance, the "
     "distance from a place (x, y, z), or Obstacle/Normal = surface"),
    ("distance_of_a_half_space",
     "subsection Obstacle\n  set Distance = z\n  set Kind = half-space\nend\n",
     "{file}: Obstacle/Distance = z with Obstacle/Kind = half-space: allowed is Kind = rigid, or Normal = surface and "
     "Kind = body"),
    ("distance_of_a_body",
     "subsection Obstacle\n  set Distance = z\n  set Kind = body\nend\n",
     "{file}: Obstacle/Distance = z with Obstacle/Kind = body: allowed is Kind = rigid, or Normal = surface and Kind = "
     "body"),
    ("normals_of_a_half_space",
     "subsection Obstacle\n  set Normal = surface\n  set Kind = half-space\nend\n",
     "{file}: Obstacle/Normal = surface with Obstacle/Kind = half-space: allowed is Kind = rigid or body"),
    ("body_that_looks_away",
     "subsection Obstacle\n  set Normal = surface\n  set Kind = body\nend\n",
     "{file}: Obstacle/Normal = surface: the contact surface of the lower body lies opposite 0 % of the face of the "
     "contact surface about (0.4419, 0.4419) mm, along its normal: allowed are 90 and more of every face; both bodies "
     "lie in their places, and the larger contact surface is that of the lower body"),
    ("bodies_in_one_place",
     sides_of_boxes(),
     "{file}: Obstacle/Normal = surface: both bodies overlap by up to 20 mm, at (10, -10) mm, which is more than a "
     "cell: allowed are bodies that lie in their places, side by side, in the axes of the same scene"),
    ("bodies_that_overlap_without_interference",
     sides_of_boxes(gap=19),
     "{file}: Obstacle/Normal = surface: both bodies overlap by up to 1 mm, at (10, -10) mm: allowed is Load "
     "program/Loads = fit: interference, which legs drive from 0 to 1, or bodies that do not overlap"),
    ("interference_of_bodies_apart",
     sides_of_boxes(gap=21, load="fit: interference"),
     "{file}: Load program/Loads: 'fit: interference' drives nothing, because the bodies overlap nowhere: allowed are "
     "meshes that overlap, a negative Obstacle/Gap, such as -0.01, or no such load"),
    ("lower_contact_surface_unknown",
     sides_of_boxes(lower="flank"),
     "{file}: Lower geometry/Contact surface = flank names no surface of Lower geometry/Shape = box: allowed are base, x-, "
     "x+, y-, y+"),
    ("distance_has_no_gradient",
     "subsection Obstacle\n  set Distance = 0*x + 0.001\nend\n",
     "{file}: Obstacle/Distance = 0*x + 0.001 has the gradient 0 at (-2.652, -2.652) mm of the contact surface, so "
     "that there is no normal: allowed is a distance whose gradient has the length 1 there, such as z"),
    ("distance_is_undefined",
     "subsection Obstacle\n  set Distance = sqrt(x)\nend\n",
     "{file}: Obstacle/Distance = sqrt(x) is not a number at (-2.652, -2.652) mm of the contact surface: allowed is "
     "a finite number (mm)"),
    ("distance_is_infinite",
     "subsection Obstacle\n  set Distance = z + 1/(x^2+y^2)\nend\n",
     "{file}: Obstacle/Distance = z + 1/(x^2+y^2) is infinite at (0, 0) mm of the contact surface: allowed is a "
     "finite number (mm)"),
    ("distance_of_the_wrong_sign",
     "subsection Obstacle\n  set Distance = -z - 5\nend\n",
     "{file}: Obstacle/Distance = -z - 5 is least at (-2.652, -2.652) mm of the contact surface, and grows out of "
     "the body there: allowed is a distance that grows into the body, positive outside of the counterface"),
    ("overlap_without_interference",
     "subsection Obstacle\n  set Gap = -0.01\n  set Normal = surface\nend\n",
     "{file}: Obstacle/Gap = -0.01 is -0.01 mm at (-2.652, -2.652) mm of the contact surface, so that body and "
     "counterface overlap there: allowed is a gap >= 0, or Load program/Loads = fit: interference, which legs drive "
     "from 0 to 1"),
    ("interference_without_overlap",
     "subsection Load program\n  set Loads = fit: interference\n  set Legs = fit 1 : 1\nend\n",
     "{file}: Load program/Loads: 'fit: interference' drives nothing, because Obstacle/Gap is negative at no place "
     "of the contact surface: allowed is a negative gap there, such as -0.01, or no such load"),
    ("two_interferences",
     "subsection Load program\n  set Loads = fit: interference ; grip: interference\n  set Legs = fit 1 grip 1 : "
     "1\nend\n",
     "{file}: Load program/Loads: 'grip: interference' beside 'fit: interference': allowed is one interference, the "
     "share of all negative gaps"),
    ("interference_of_the_lower_body",
     "subsection Obstacle\n  set Kind = body\nend\nsubsection Load program\n  set Loads = fit: interference on "
     "lower\n  set Legs = fit 1 : 1\nend\n",
     "{file}: Load program/Loads: 'fit: interference on lower': allowed is 'interference' without 'on lower', "
     "because it is the overlap of the body and its counterface"),
    ("interference_on_a_surface",
     "subsection Load program\n  set Loads = fit: interference on base\n  set Legs = fit 1 : 1\nend\n",
     "{file}:3: Load program/Loads = fit: interference on base: allowed is 'interference' without a surface"),
    ("side_of_a_clamped_body",
     "subsection Geometry\n  set Contact surface = side\nend\nsubsection Obstacle\n  set Normal = surface\nend\n",
     "{file}: Geometry/Contact surface = side with Geometry/Top face = clamped, so that the rim of side is a part of "
     "the held face, too: allowed is Top face = guided or free, or a Mesh file whose contact surface ends below the "
     "held face"),
    ("side_above_a_plane",
     "subsection Geometry\n  set Contact surface = side\n  set Top face = guided\nend\n",
     "{file}: Geometry/Contact surface = side on a counterface with the normal z: allowed is base, or a counterface "
     "by Obstacle/Distance or with Obstacle/Normal = surface"),
    ("side_of_a_box",
     "subsection Geometry\n  set Shape = box\n  set Contact surface = side\n  set Top face = guided\nend\nsubsection "
     "Obstacle\n  set Normal = surface\nend\n",
     "{file}: Geometry/Contact surface = side names no surface of Geometry/Shape = box: allowed are base, x-, x+, "
     "y-, y+"),
    ("side_y_of_a_section",
     "subsection Geometry\n  set Shape = box\n  set Kind = plane strain\n  set Contact surface = y-\n  set Top face "
     "= guided\nend\nsubsection Obstacle\n  set Normal = surface\nend\n",
     "{file}: Geometry/Contact surface = y- names no surface of Geometry/Shape = box in plane strain: allowed are "
     "base, x-, x+"),
    ("top_touches",
     "subsection Geometry\n  set Contact surface = base, top\nend\nsubsection Obstacle\n  set Normal = surface\nend\n",
     "{file}: Geometry/Contact surface = base, top is the held face: allowed are base, side"),
    ("side_touches_twice",
     "subsection Geometry\n  set Contact surface = side, side\n  set Top face = free\nend\nsubsection Obstacle\n  "
     "set Normal = surface\nend\n",
     "{file}: Geometry/Contact surface = side, side names side twice: allowed is once"),
    ("support_of_a_side_that_touches",
     "subsection Geometry\n  set Contact surface = side\n  set Top face = guided\n  set Supports = side: "
     "z\nend\nsubsection Obstacle\n  set Normal = surface\nend\n",
     "{file}: Geometry/Supports = side: z is the contact surface, which only the counterface may hold: allowed are "
     "base, top"),
    ("pressure_on_a_side_that_touches",
     "subsection Geometry\n  set Contact surface = side\n  set Top face = guided\nend\nsubsection Obstacle\n  set "
     "Normal = surface\nend\nsubsection Load program\n  set Loads = p: pressure on side\n  set Legs = p 1 : 1\nend\n",
     "{file}: Load program/Loads: 'p: pressure on side' acts on the contact surface, where the counterface alone "
     "may: allowed are base, top"),
    ("distance_deep_inside",
     "subsection Obstacle\n  set Distance = z - 5\nend\n",
     "{file}: Obstacle/Distance is -5 mm at (0.8839, 0.8839) mm of the contact surface, which is inside of the "
     "counterface by more than a cell: allowed are overlaps smaller than that, and a distance that is positive "
     "outside of the counterface"),
    ("first_axis_and_angle",
     "subsection Friction\n  set First axis = 1, 0, 0\n  set Orthotropy angle = 30\nend\n",
     "{file}: Friction/First axis with Friction/Orthotropy angle = 30: allowed is one of both, because each says "
     "where the axes of friction are"),
    ("first_axis_along_the_normal",
     "subsection Friction\n  set First axis = 0, 0, 1\nend\n",
     "{file}: Friction/First axis: the first axis of orthotropic friction is along the normal at (-2.652, -2.652) mm "
     "of the contact surface: allowed is a direction that is along the surface, such as First axis = 0, 0, 1 where "
     "the normal is horizontal"),
    ("first_axis_is_undefined",
     "subsection Friction\n  set First axis = 1, sqrt(x), 0\nend\n",
     "{file}: Friction/First axis is not a number at (-2.652, -2.652) mm of the contact surface: allowed are three "
     "finite numbers"),
    ("curved_surface_that_is_none", of_file("pipe", "shaft: plane"),
     "{file}: Geometry/Curved surfaces = shaft is no physical surface: allowed in {absolute}/included/pipe.msh are bore "
     "(1), rim (2), left (3), right (4), front (5), back (6), each once, and y min (0), y max (5) and other planes on "
     "its outside such as x = 0"),
    ("node_off_its_cylinder", of_file("pipe", "bore: cylinder through 0 0 0.1 along 0 1 0"),
     "{file}: Geometry/Curved surfaces = bore: cylinder through 0 0 0.1 along 0 1 0: the node at (0, 0, 4) mm is 3.9 mm "
     "off the axis, and the mean radius is 3.91995035 mm: allowed is 1e-6 of it for all nodes of the surface; correct "
     "the axis, or give the round part a physical surface of its own"),
    ("node_off_its_sphere", of_file("pipe", "rim: sphere about 0 0 0"),
     "{file}: Geometry/Curved surfaces = rim: sphere about 0 0 0: the node at (-4.243, 0, 4.243) mm is 6 mm off the "
     "centre, and the mean radius is 6.90512484 mm: allowed is 1e-6 of it for all nodes of the surface; correct the "
     "centre, or give the round part a physical surface of its own"),
    ("node_off_its_plane", of_file("pipe", "rim: plane"),
     "{file}: Geometry/Curved surfaces = rim: plane: the node at (0, 0, 6) mm is 1.17157288 mm off the mean plane of "
     "its surface: allowed is 1e-6 of the length of the body; name a surface that is plane"),
    ("sphere_in_a_section", of_file("section", "bore: sphere about 0 0 0", "plane strain"),
     "{file}: Geometry/Curved surfaces = bore: sphere about 0 0 0 with Geometry/Kind = plane strain: allowed are "
     "cylinders along y, such as 'cylinder through 0 0 0 along 0 1 0', and planes"),
    ("inclined_cylinder_in_a_section", of_file("section", "bore: cylinder through 0 0 0 along 1 1 0", "plane strain"),
     "{file}: Geometry/Curved surfaces = bore: cylinder through 0 0 0 along 1 1 0 with Geometry/Kind = plane strain: "
     "allowed are cylinders along y, such as 'cylinder through 0 0 0 along 0 1 0', and planes"),
    ("inverted_by_an_edge", of_file("bent"),
     "{file}: {absolute}/included/bent.msh: the cell at (0.5, 0.5, 0.5) mm is inverted: allowed are hexahedra with a "
     "positive volume at every point, not only at their corners (gmsh: Mesh.HighOrderOptimize = 1)"),
    ("two_orders", of_file("two_orders"),
     "{file}: {absolute}/included/two_orders.msh: has 1 element of first order beside 6 of second order: allowed is one "
     "order for all (gmsh: Mesh.ElementOrder = 2)"),
]
