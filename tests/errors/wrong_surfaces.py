# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Counterfaces, contact surfaces and axes of friction that cannot be: name of the file, its text without the message, the
message."""
FOLDER = "surfaces"
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
     "{file}: Obstacle/Distance = z with Obstacle/Kind = half-space, whose normal is z: allowed is Kind = rigid"),
    ("normals_of_a_body",
     "subsection Obstacle\n  set Normal = surface\n  set Kind = body\nend\n",
     "{file}: Obstacle/Normal = surface with Obstacle/Kind = body, whose normal is z: allowed is Kind = rigid"),
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
]
