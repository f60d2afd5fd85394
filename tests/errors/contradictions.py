# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Entries that do not fit together: name of the file, its text without the message, the message."""
FOLDER = "contradictions"
PLANE = "subsection Geometry\n  set Kind = plane strain\n  set Shape = box\nend\n"
ON_BODY = "subsection Obstacle\n  set Kind = body\nend\n"
GRID = "subsection Geometry\n  set Shape = half-space\n  set Sizes = 4, 4\nend\nsubsection Mesh\n  set Cells = 16, 16\nend\n"


def of_half_space(name, section, entry, value, message):
    """A half-space with an entry that it does not take."""
    return (f"grid_{name}", GRID + f"subsection {section}\n  set {entry} = {value}\nend\n", "{file}: " + message)


WITH = " with Geometry/Shape = half-space: allowed is "
HALF_SPACES = [
    ("grid_without_sizes", "subsection Geometry\n  set Shape = half-space\nend\n",
     "{file}: Geometry/Sizes = 20, 20, 10" + WITH + "l_x, l_y, the part of its surface that may touch"),
    of_half_space("of_cells", "Mesh", "Cells", "8, 8, 8", "Mesh/Cells = 8, 8, 8" + WITH + "n_x, n_y, the patches of that part"),
    of_half_space("of_one", "Mesh", "Cells", "1, 8", "Mesh/Cells = 1, 8" + WITH + "at least 2 patches along x and y"),
    of_half_space("too_fine", "Mesh", "Cells", "4096, 8\n  set Refinements = 1",
                  "Mesh/Refinements = 1" + WITH + "a number that leaves at most 4096 patches along x and y"),
    of_half_space("graded", "Mesh", "Edge grading", "2", "Mesh/Edge grading = 2" + WITH + "1, because its grid is regular"),
    of_half_space("on_multigrid", "Mesh", "Backend", "multigrid",
                  "Mesh/Backend = multigrid" + WITH + "auto, because it has no mesh"),
    of_half_space("adaptive", "Mesh", "Adaptive", "2", "Mesh/Adaptive = 2" + WITH + "0, because it has no mesh"),
    of_half_space("refined_cells", "Mesh", "Refined cells", "0-3",
                  "Mesh/Refined cells is set" + WITH + "nothing, because it has no mesh"),
    of_half_space("accuracy", "Mesh", "Accuracy", "1 %",
                  "Mesh/Accuracy = 1 %" + WITH + "0; Mesh/Cells are the patches of a half-space"),
    of_half_space("free", "Geometry", "Top face", "free",
                  "Geometry/Top face = free" + WITH + "clamped: its far field moves as a rigid body"),
    of_half_space("supported", "Geometry", "Supports", "side: x",
                  "Geometry/Supports = side: x with Geometry/Shape = half-space, whose surfaces have no names: allowed is "
                  "nothing"),
    of_half_space("plane_strain", "Geometry", "Kind", "plane strain",
                  "Geometry/Shape = half-space with Geometry/Kind = plane strain: allowed is box or file"),
    of_half_space("orthotropic", "Material", "Law", "orthotropic",
                  "Material/Law = orthotropic" + WITH + "one isotropic material, of which its closed forms are"),
    of_half_space("warm", "Material", "Thermal expansion", "1e-5\nend\nsubsection Load program\n  set Loads = warm: temperature",
                  "Load program/Loads: 'warm: temperature'" + WITH + "an interference; motions and forces of the far field "
                  "stand in the legs"),
    of_half_space("on_body", "Obstacle", "Kind", "body",
                  "Obstacle/Kind = body with Geometry/Shape = half-space: allowed is rigid or half-space"),
    of_half_space("by_sweeps", "Contact solver", "Method", "uzawa",
                  "Contact solver/Method = uzawa with Geometry/Shape = half-space, whose compliance is no matrix: allowed is "
                  "newton"),
    of_half_space("half", "Mesh", "Model", "half",
                  "Mesh/Model = half is not possible: Geometry/Shape = half-space is computed as a whole, because the "
                  "products of its grid need no symmetry to be fast; possible models are full"),
    of_half_space("with_lines", "Geometry", "Periodic", "yes\nend\nsubsection Output\n  set Lines = axis: 0 0 0 to 0 0 1, 10",
                  "Output/Lines with Geometry/Periodic = yes: allowed is nothing, because the closed forms of what is below "
                  "the surface know no images; Probes are points of the surface"),
    of_half_space("turned", "Geometry", "Periodic", "yes\nend\nsubsection Load program\n  set Legs = uz -0.01 rz 1 : 2",
                  "Load program/Legs: rz in leg 1 with Geometry/Periodic = yes: allowed are ux, uy, uz and their forces, "
                  "because a surface that turns is not periodic"),
]
ROWS = [
    *HALF_SPACES,
    ("accuracy_and_resolution", "subsection Mesh\n  set Resolution = fine\n  set Accuracy   = 1 %\nend\n",
     "{file}: Mesh/Accuracy = 1 % with Mesh/Resolution = fine: allowed is one of them; an accuracy chooses the "
     "mesh by itself"),
    ("accuracy_and_rim_grading", "subsection Mesh\n  set Accuracy    = 0.5 %\n  set Rim grading = 0.4\nend\n",
     "{file}: Mesh/Accuracy = 0.5 % chooses the mesh, but Mesh/Rim grading = 0.4 is set beside it: allowed is the "
     "default 1, or Accuracy = 0"),
    ("axisymmetric_moved_along_x",
     "subsection Mesh\n  set Model = axisymmetric\nend\nsubsection Friction\n  set Coefficients   = 0.2, 0.2\n  "
     "set Slip potential = 1, 1\nend\nsubsection Load program\n  set Legs = 0.01 0 -0.1 : 5\nend\n",
     "{file}: Mesh/Model = axisymmetric is not possible: the load program moves the held face along x; possible "
     "models are full, half"),
    ("axisymmetric_orthotropic_friction", "subsection Mesh\n  set Model = axisymmetric\nend\n",
     "{file}: Mesh/Model = axisymmetric is not possible: Friction/Coefficients = 0.3, 0.15 differ, which makes "
     "friction orthotropic; possible models are full, half, quarter"),
    ("axisymmetric_orthotropic_slip",
     "subsection Mesh\n  set Model = axisymmetric\nend\nsubsection Friction\n  set Coefficients     = 0.2, 0.2\n  "
     "set Slip potential   = 0.2, 0.1\n  set Orthotropy angle = 10\nend\n",
     "{file}: Mesh/Model = axisymmetric is not possible: Friction/Slip potential = 0.2, 0.1 differ, which makes "
     "slip orthotropic; possible models are full"),
    ("degree_4_of_a_solid", "subsection Mesh\n  set Core cells = 8\n  set Degree     = 4\nend\n",
     "{file}: Mesh/Degree = 4 with the quarter model: allowed is a whole number from 1 to 3"),
    ("degree_4_quarter_isotropic",
     "subsection Mesh\n  set Model  = quarter\n  set Degree = 4\nend\nsubsection Friction\n  set Coefficients   = "
     "0.2, 0.2\n  set Slip potential = 1, 1\nend\n",
     "{file}: Mesh/Degree = 4 with the quarter model: allowed is a whole number from 1 to 3, or Mesh/Model = "
     "axisymmetric"),
    ("half_space_axisymmetric",
     "subsection Mesh\n  set Model = axisymmetric\nend\nsubsection Friction\n  set Coefficients = 0.2, 0.2\nend\n"
     "subsection Obstacle\n  set Kind = half-space\nend\n",
     "{file}: Mesh/Model = axisymmetric is not possible: Obstacle/Kind = half-space has no section (r, z); possible "
     "models are full, half, quarter"),
    ("body_on_multigrid", "subsection Mesh\n  set Backend = multigrid\nend\n" + ON_BODY,
     "{file}: Obstacle/Kind = body with Mesh/Backend = multigrid, whose V-cycles solve the upper body only: "
     "allowed is auto or condensed, or Kind = rigid or half-space"),
    ("body_axisymmetric",
     "subsection Mesh\n  set Model = axisymmetric\nend\nsubsection Friction\n  set Coefficients = 0.2, 0.2\nend\n"
     + ON_BODY,
     "{file}: Mesh/Model = axisymmetric is not possible: Obstacle/Kind = body has no section (r, z); possible models "
     "are full, half, quarter"),
    ("body_adaptive", "subsection Mesh\n  set Adaptive = 2\nend\n" + ON_BODY,
     "{file}: Mesh/Adaptive = 2 with Obstacle/Kind = body: allowed is 0, because cells are halved in one body "
     "only (Mesh/Refinements halves all)"),
    ("body_accuracy", "subsection Mesh\n  set Accuracy = 5 %\nend\n" + ON_BODY,
     "{file}: Mesh/Accuracy = 5 % with Obstacle/Kind = body: allowed is 0, because the search refines one body "
     "only"),
    ("body_refined_cells", "subsection Mesh\n  set Refined cells = 1\nend\n" + ON_BODY,
     "{file}: Mesh/Refined cells is set with Obstacle/Kind = body: allowed is nothing, because the faces of both bodies "
     "are joined without hanging nodes"),
    ("body_degree_4", "subsection Lower mesh\n  set Degree = 4\nend\n" + ON_BODY,
     "{file}: Lower mesh/Degree = 4: allowed is a whole number from 1 to 3"),
    ("body_points", "subsection Lower mesh\n  set Degree = 2\n  set Quadrature points = 2\nend\n" + ON_BODY,
     "{file}: Lower mesh/Quadrature points = 2: with Lower mesh/Degree = 2 allowed is 0 or more than the degree (fewer "
     "points leave deformations without stiffness)"),
    ("body_odd_cells",
     "subsection Mesh\n  set Model = quarter\nend\nsubsection Lower mesh\n  set Core cells = 5\nend\n" + ON_BODY,
     "{file}: Mesh/Model = quarter is not possible: Lower mesh/Core cells = 5 is odd; possible models are full"),
    ("one_fatigue_limit", "subsection Material\n  set Fatigue = bending limit: 300\nend\n",
     "{file}: Material/Fatigue has one of bending limit and torsion limit: allowed are both or neither, because other "
     "constants follow from their ratio, or all of findley k, crossland alpha and dang van a"),
    ("fatigue_limits_of_no_material",
     "subsection Lower material\n  set Fatigue = bending limit: 400 ; torsion limit: 100\nend\n" + ON_BODY,
     "{file}: Lower material/Fatigue has a torsion limit that is 0.25 of the bending limit: allowed are 0.5 up to 1, "
     "or all of findley k, crossland alpha and dang van a"),
    ("body_regions", "subsection Lower material\n  set Regions = core: 70000, 0.3\nend\n" + ON_BODY,
     "{file}: Lower material/Regions is set without a mesh file: allowed is nothing, or Lower geometry/Shape = file, "
     "because regions are physical volumes of the file"),
    ("body_without_file", "subsection Lower geometry\n  set Shape = file\nend\n" + ON_BODY,
     "{file}: Lower geometry/Mesh file is empty with Lower geometry/Shape = file: allowed is the path of a mesh by "
     "Gmsh"),
    ("plane_strain_cylinder", "subsection Geometry\n  set Kind = plane strain\nend\n",
     "{file}: Geometry/Shape = cylinder with Geometry/Kind = plane strain: allowed is box or file"),
    ("plane_strain_half_space",
     PLANE + "subsection Obstacle\n  set Kind = half-space\nend\nsubsection Load program\n  set Legs = uz -0.1 : 1\nend\n",
     "{file}: Load program/Legs: uz is a motion, or not named, in leg 1: allowed with Obstacle/Kind = half-space in plane "
     "strain is a force Fz, such as 0, because the displacement of a half-plane has no datum"),
    ("plane_strain_turned", PLANE + "subsection Load program\n  set Legs = uz -0.1 rx 0.1 : 1\nend\n",
     "{file}: Geometry/Kind = plane strain is not possible: the load program turns the held face about x; allowed is "
     "Kind = solid"),
    ("plane_strain_quarter", PLANE + "subsection Mesh\n  set Model = quarter\nend\n",
     "{file}: Mesh/Model = quarter is not possible: Geometry/Kind = plane strain is computed in a section (x, z); "
     "possible models are full, half, auto"),
    ("plane_strain_multigrid", PLANE + "subsection Mesh\n  set Backend = multigrid\nend\n",
     "{file}: Mesh/Backend = multigrid with Geometry/Kind = plane strain, but multigrid solves solids only: allowed is "
     "auto or condensed"),
    ("plane_strain_guided",
     "subsection Geometry\n  set Kind = plane strain\n  set Shape = box\n  set Top face = guided\nend\n"
     "subsection Mesh\n  set Model = full\nend\n",
     "{file}: Geometry/Top face = guided needs the half model, which Mesh/Model = half and auto choose"),
    ("plane_strain_lower_cylinder", PLANE + ON_BODY,
     "{file}: Lower geometry/Shape = cylinder with Geometry/Kind = plane strain: allowed is box or file"),
    ("plane_strain_lower_thickness",
     PLANE + "subsection Lower geometry\n  set Shape = box\n  set Sizes = 20, 5, 10\nend\n" + ON_BODY,
     "{file}: Lower geometry/Sizes: l_y = 5 mm with Geometry/Kind = plane strain: allowed is the thickness of the upper "
     "body, 20 mm"),
    ("support_on_base", "subsection Geometry\n  set Supports = base: z\nend\n",
     "{file}: Geometry/Supports = base: z is the contact surface, which only the counterface may hold: allowed are top, "
     "side"),
    ("support_of_a_box_on_a_cylinder", "subsection Geometry\n  set Supports = x+: x\nend\n",
     "{file}: Geometry/Supports = x+: x names no surface of Geometry/Shape = cylinder: allowed are top, side"),
    ("support_across_plane_strain",
     "subsection Geometry\n  set Kind = plane strain\n  set Shape = box\n  set Supports = y+: y\nend\n",
     "{file}: Geometry/Supports = y+: y names no surface of Geometry/Shape = box in plane strain: allowed are top, x-, x+"),
    ("support_twice", "subsection Geometry\n  set Supports = side: x ; side: y\nend\n",
     "{file}: Geometry/Supports names side twice: allowed is once, with all its directions"),
    ("support_all_around",
     "subsection Geometry\n  set Supports = side: x\nend\nsubsection Mesh\n  set Model = axisymmetric\nend\nsubsection "
     "Friction\n  set Coefficients = 0.2, 0.2\nend\n",
     "{file}: Mesh/Model = axisymmetric is not possible: Geometry/Supports = side: x is not the same all around; possible "
     "models are full, half, quarter"),
    ("support_of_one_side",
     "subsection Geometry\n  set Shape = box\n  set Supports = x+: x\nend\nsubsection Mesh\n  set Model = quarter\nend\n",
     "{file}: Mesh/Model = quarter is not possible: Geometry/Supports = x+: x has no mirror image on x-; possible models "
     "are full, half"),
    ("guided_pushed_with_supports",
     "subsection Geometry\n  set Shape = box\n  set Top face = guided\n  set Supports = x-: x ; y-: y\nend\nsubsection Load "
     "program\n  set Legs = Fx 10 : 1\nend\n",
     "{file}: Load program/Legs: Fx in leg 1 with Geometry/Top face = guided, which is free sideways: allowed are uz, Fz, "
     "rx, ry, Mx and My, or Top face = clamped"),
    ("guided_with_one_roller",
     "subsection Geometry\n  set Shape = box\n  set Top face = guided\n  set Supports = x-: x\nend\nsubsection Mesh\n  set "
     "Model = full\nend\n",
     "{file}: Geometry/Supports leave the full model free to move along y: allowed are supports that hold it, or Top face "
     "= clamped"),
    ("problems_with_supports",
     "subsection Geometry\n  set Shape = box\n  set Supports = x-: x\nend\nsubsection Load program\n  set Legs = Fz -10 : "
     "1\nend\nsubsection Output\n  set Problems = 1\nend\n",
     "{file}: Output/Problems with Geometry/Supports and Fz in leg 1 of Load program/Legs: FCLIB's format has no "
     "place for the stiffness of the supports against the held face; allowed are motions, or Problems = 0"),
    ("guided_full", "subsection Geometry\n  set Top face = guided\nend\nsubsection Mesh\n  set Model = full\nend\n",
     "{file}: Geometry/Top face = guided with Mesh/Model = full is not possible: the model could drift sideways; "
     "possible models are quarter and auto"),
    ("guided_full_isotropic",
     "subsection Geometry\n  set Top face = guided\nend\nsubsection Mesh\n  set Model = full\nend\nsubsection "
     "Friction\n  set Coefficients   = 0.2, 0.2\n  set Slip potential = 1, 1\nend\n",
     "{file}: Geometry/Top face = guided with Mesh/Model = full is not possible: the model could drift sideways; "
     "possible models are quarter, axisymmetric and auto"),
    ("guided_half", "subsection Geometry\n  set Top face = guided\nend\nsubsection Mesh\n  set Model = half\nend\n",
     "{file}: Geometry/Top face = guided with Mesh/Model = half is not possible: the model could drift sideways; "
     "possible models are quarter and auto"),
    ("guided_moved_along_x",
     "subsection Geometry\n  set Top face = guided\nend\nsubsection Load program\n  set Legs = 0 0 -0.1 : 5 ; 0.01 "
     "0 -0.1 : 5\nend\n",
     "{file}: Geometry/Top face = guided needs the quarter model, which is not possible: the load program moves "
     "the held face along x"),
    ("guided_turned_friction",
     "subsection Geometry\n  set Top face = guided\nend\nsubsection Friction\n  set Orthotropy angle = 30\nend\n",
     "{file}: Geometry/Top face = guided needs the quarter model, which is not possible: Friction/Orthotropy angle "
     "= 30 turns the axes of friction"),
    ("half_isotropic_odd_core",
     "subsection Mesh\n  set Model      = half\n  set Core cells = 5\nend\nsubsection Friction\n  set "
     "Coefficients   = 0.2, 0.2\n  set Slip potential = 1, 1\nend\n",
     "{file}: Mesh/Model = half is not possible: Mesh/Core cells = 5 is odd; possible models are full, axisymmetric"),
    ("half_odd_core", "subsection Mesh\n  set Model = half\n  set Core cells = 5\nend\n",
     "{file}: Mesh/Model = half is not possible: Mesh/Core cells = 5 is odd; possible models are full"),
    ("half_turned_friction",
     "subsection Mesh\n  set Model = half\nend\nsubsection Friction\n  set Orthotropy angle = 60\nend\n",
     "{file}: Mesh/Model = half is not possible: Friction/Orthotropy angle = 60 turns the axes of friction; "
     "possible models are full"),
    ("layer_grading_too_coarse", "subsection Mesh\n  set Layers = 200\n  set Layer grading = 1.2\nend\n",
     "{file}: Mesh/Layer grading = 1.2 with 200 layers: allowed is a value that leaves every layer at least 1e-6 of the "
     "height"),
    ("layer_grading_too_fine", "subsection Mesh\n  set Layers = 20\n  set Layer grading = 0.2\nend\n",
     "{file}: Mesh/Layer grading = 0.2 with 20 layers: allowed is a value that leaves every layer at least 1e-6 of the "
     "height"),
    ("line_above_the_body", "subsection Output\n  set Lines = axis: 0 0 0 to 0 0 12, 13\nend\n",
     "{file}: Output/Lines: point 12 of 13 of 'axis' at (0, 0, 11) lies in no body: allowed are points of the body "
     "(cylinder, radius 10 mm, height 10 mm), whose contact surface is at z = 0 and whose other points are above it"),
    ("line_beside_the_section", PLANE + "subsection Output\n  set Lines = L: 0 0 1 to 0 99 1, 2\nend\n",
     "{file}: Output/Lines: point 2 of 2 of 'L' at (0, 99, 1) lies in no body: allowed are points of the body "
     "(box, 20 x 20 x 10 mm), whose contact surface is at z = 0 and whose other points are above it; y from -10 to 10 mm"),
    ("line_below_a_rigid_obstacle",
     "subsection Output\n  set Lines = in: 0 0 5 to 1 0 5, 2 ; below: 9 0 0 to 9 0 -1, 5\nend\n",
     "{file}: Output/Lines: point 2 of 5 of 'below' at (9, 0, -0.25) lies in no body: allowed are points of the body "
     "(cylinder, radius 10 mm, height 10 mm), whose contact surface is at z = 0 and whose other points are above it"),
    ("line_below_the_lower_body", ON_BODY + "subsection Output\n  set Lines = L: 0 0 0 to 0 0 -99, 2\nend\n",
     "{file}: Output/Lines: point 2 of 2 of 'L' at (0, 0, -99) lies in no body: allowed are points of the body "
     "(cylinder, radius 10 mm, height 10 mm), whose contact surface is at z = 0 and whose other points are above it, "
     "and of the lower body (cylinder, radius 10 mm, height 10 mm) below it"),
    ("no_cycles", "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ; 0 0 0 : 10\n  set Cycles = 0\nend\n",
     "{file}: Load program/Cycles = 0 and Load program/Preload is empty: allowed is at least one cycle or a preload"),
    ("no_legs", "subsection Load program\n  set Legs = \n  set Cycles = 3\nend\n",
     "{file}: Load program/Legs is empty and Load program/Preload is empty: allowed is at least one leg, such as "
     "'0 0 -0.1 : 5'"),
    ("probe_outside", "subsection Output\n  set Probes = P: 8 8\nend\n",
     "{file}: Output/Probes: 'P' at (8, 8) is off the contact surface: allowed are points within Geometry/Radius = "
     "10 of the axis"),
    ("problems_axisymmetric",
     "subsection Friction\n  set Coefficients = 0.2, 0.2\nend\nsubsection Output\n  set Problems = 1\nend\n",
     "{file}: Output/Problems = 1 with the axisymmetric model, whose nodes are rings: allowed is 0, or Mesh/Model = full, "
     "half or quarter"),
    ("problems_of_forces",
     "subsection Friction\n  set Slip potential = 0.05, 0.2\nend\nsubsection Load program\n  set Legs = uz -0.1 : 2 ; "
     "Fx 10 : 2\nend\nsubsection Output\n  set Problems = 2\nend\n",
     "{file}: Output/Problems = 2 with forces in the load program and a slip rule that is not associated, which have no "
     "common form in FCLIB: allowed is 0, or Friction/Slip potential = associated"),
    ("problems_on_multigrid",
     "subsection Mesh\n  set Backend = multigrid\nend\nsubsection Output\n  set Problems = 1\nend\n",
     "{file}: Output/Problems = 1 with Mesh/Backend = multigrid, which has no matrix W to write: allowed is 0, or Backend "
     "= auto or condensed"),
    ("quadrature_1_for_degree_1", "subsection Mesh\n  set Degree = 1\n  set Quadrature points = 1\nend\n",
     "{file}: Mesh/Quadrature points = 1: with Mesh/Degree = 1 allowed is 0 or more than the degree (fewer points "
     "leave deformations without stiffness)"),
    ("quadrature_2_for_degree_2", "subsection Mesh\n  set Degree = 2\n  set Quadrature points = 2\nend\n",
     "{file}: Mesh/Quadrature points = 2: with Mesh/Degree = 2 allowed is 0 or more than the degree (fewer points "
     "leave deformations without stiffness)"),
    ("quadrature_3_for_degree_3", "subsection Mesh\n  set Degree = 3\n  set Quadrature points = 3\nend\n",
     "{file}: Mesh/Quadrature points = 3: with Mesh/Degree = 3 allowed is 0 or more than the degree (fewer points "
     "leave deformations without stiffness)"),
    ("quarter_hardly_turned_friction",
     "subsection Mesh\n  set Model = quarter\nend\nsubsection Friction\n  set Orthotropy angle = 1e-9\nend\n",
     "{file}: Mesh/Model = quarter is not possible: Friction/Orthotropy angle = 1e-09 turns the axes of friction; "
     "possible models are full"),
    ("quarter_moved_along_x",
     "subsection Mesh\n  set Model = quarter\nend\nsubsection Load program\n  set Legs = 0 0 -0.1 : 5 ; 0.01 0 "
     "-0.1 : 5\nend\n",
     "{file}: Mesh/Model = quarter is not possible: the load program moves the held face along x; possible models "
     "are full, half"),
    ("quarter_odd_core", "subsection Mesh\n  set Model = quarter\n  set Core cells = 7\nend\n",
     "{file}: Mesh/Model = quarter is not possible: Mesh/Core cells = 7 is odd; possible models are full"),
    ("quarter_preloaded_along_y",
     "subsection Mesh\n  set Model = quarter\nend\nsubsection Load program\n  set Preload = 0 0.01 -0.05 : 5\nend\n",
     "{file}: Mesh/Model = quarter is not possible: the load program moves the held face along y; possible models "
     "are full, half"),
    ("quarter_turned_friction",
     "subsection Mesh\n  set Model = quarter\nend\nsubsection Friction\n  set Orthotropy angle = 30\nend\n",
     "{file}: Mesh/Model = quarter is not possible: Friction/Orthotropy angle = 30 turns the axes of friction; "
     "possible models are full"),
    ("quarter_turned_slip",
     "subsection Mesh\n  set Model = quarter\nend\nsubsection Friction\n  set Coefficients = 0.3, 0.3\n  set Slip "
     "potential = 2, 1\n  set Orthotropy angle = 45\nend\n",
     "{file}: Mesh/Model = quarter is not possible: Friction/Orthotropy angle = 45 turns the axes of friction; "
     "possible models are full"),
    ("radius_in_metres",
     "subsection Geometry\n  set Radius = 0.01\n  set Height = 0.01\nend\nsubsection Output\n  set Probes = P: "
     "6.72 6.72\nend\n",
     "{file}: Load program/Legs: u_z = -0.1 mm presses the body flat: allowed is more than -Geometry/Height = "
     "-0.01 mm"),
    ("resolution_and_degree", "subsection Mesh\n  set Resolution = medium\n  set Degree     = 3\nend\n",
     "{file}: Mesh/Resolution = medium chooses the mesh, but Mesh/Degree = 3 is set beside it: allowed is the "
     "default 2, or Resolution = custom"),
    ("resolution_paper_and_layers", "subsection Mesh\n  set Resolution = paper\n  set Layers     = 6\nend\n",
     "{file}: Mesh/Resolution = paper chooses the mesh, but Mesh/Layers = 6 is set beside it: allowed is the "
     "default 4, or Resolution = custom"),
    ("rim_grading_too_coarse", "subsection Mesh\n  set Rings = 8\n  set Rim grading = 10\nend\n",
     "{file}: Mesh/Rim grading = 10 with 8 rings: allowed is a value that leaves every ring at least 1e-6 of the thickness "
     "of all rings"),
    ("rim_grading_too_fine", "subsection Mesh\n  set Rings = 8\n  set Rim grading = 0.1\nend\n",
     "{file}: Mesh/Rim grading = 0.1 with 8 rings: allowed is a value that leaves every ring at least 1e-6 of the thickness "
     "of all rings"),
    ("second_probe_outside", "subsection Output\n  set Probes = Centre: 0 0 ; Far: 0 -11\nend\n",
     "{file}: Output/Probes: 'Far' at (0, -11) is off the contact surface: allowed are points within "
     "Geometry/Radius = 10 of the axis"),
    ("factor_infinite_at_the_start", "subsection Friction\n  set Factor = 1/s\nend\n",
     "{file}: Friction/Factor = 1/s is infinite at the start, where s, w, p and v are 0 and n is 1: allowed is a finite "
     "number > 0 there, as 1 + s/(0.1 + s) has it"),
    ("factor_of_a_speed_without_times", "subsection Friction\n  set Factor = 1/(1 + v)\nend\n",
     "{file}: Friction/Factor = 1/(1 + v) contains v, the speed of slip, but the load program has no times: allowed is a "
     "Load program/Program file with a column 'time', or an expression without v"),
    ("factor_that_is_periodic",
     "subsection Friction\n  set Factor = 1 + w\nend\nsubsection Load program\n  set Jump when periodic = 1e-6\nend\n",
     "{file}: Load program/Jump when periodic = 1e-06 with Friction/Factor = 1 + w: allowed is 0, because friction that "
     "changes from cycle to cycle is not periodic (Load program/Jump change of friction jumps cycles)"),
    ("factor_that_jumps_without_memory",
     "subsection Friction\n  set Factor = 1 + p\nend\nsubsection Load program\n  set Jump change of friction = 0.1\nend\n",
     "{file}: Load program/Jump change of friction = 0.1 with Friction/Factor = 1 + p: allowed is 0, because no slip, "
     "energy or cycle changes this friction"),
    ("factor_that_jumps_with_wear",
     "subsection Friction\n  set Factor = 1 + n\nend\nsubsection Wear\n  set Law = archard\n  set Coefficient = 1e-8\n"
     "  set Largest depth of a jump = 1e-3\nend\n",
     "{file}: Wear/Largest depth of a jump = 0.001 with Friction/Factor = 1 + n: allowed is 0, or a Load program/Jump "
     "change of friction > 0, which bounds what friction changes in a jump"),
    ("factor_that_jumps_and_wears",
     "subsection Friction\n  set Factor = 1 + n\nend\nsubsection Wear\n  set Law = archard\n  set Coefficient = 1e-8\nend\n"
     "subsection Load program\n  set Jump change of friction = 0.1\nend\n",
     "{file}: Load program/Jump change of friction = 0.1 with Wear/Law = archard: allowed is 0, or a Wear/Largest depth of a "
     "jump > 0, which bounds what a jump wears"),
    ("stop_and_jump",
     "subsection Load program\n  set Stop when periodic = 1e-8\n  set Jump when periodic = 1e-6\nend\n",
     "{file}: Load program/Stop when periodic = 1e-08 and Load program/Jump when periodic = 1e-06: allowed is one "
     "of them, the other 0 (a run that stops then has no cycles left to jump)"),
    ("wear_of_nothing", "subsection Wear\n  set Law = archard\nend\n",
     "{file}: Wear/Coefficient = 0 with Wear/Law = archard: allowed is a number > 0, in mm^3/(N mm) = 1/MPa, or "
     "Law = none"),
    ("wear_that_is_periodic",
     "subsection Wear\n  set Law = energy\n  set Coefficient = 1e-8\nend\n"
     "subsection Load program\n  set Jump when periodic = 1e-6\nend\n",
     "{file}: Load program/Jump when periodic = 1e-06 with Wear/Law = energy: allowed is 0, because no cycle of a "
     "surface that wears ends as it began (Wear/Largest depth of a jump jumps cycles)"),
    ("too_many_steps", "subsection Load program\n  set Legs = 0 0 -0.1 : 1000001\nend\n",
     "{file}: Load program: Preload, Legs and Cycles = 1 make 1000001 load steps: allowed are 1000000"),
    ("too_many_steps_beyond_32_bits",
     "subsection Load program\n  set Legs = 0 0 -0.1 : 4000000000 ; 0 0 0 : 4000000000\n  set Cycles = 1000000\n"
     "end\n",
     "{file}: Load program: Preload, Legs and Cycles = 1000000 make 8000000000000000 load steps: allowed are 1000000"),
    ("too_many_steps_by_cycles",
     "subsection Load program\n  set Legs = 0 0 -0.1 : 500 ; 0 0 0 : 500\n  set Cycles = 1001\nend\n",
     "{file}: Load program: Preload, Legs and Cycles = 1001 make 1001000 load steps: allowed are 1000000"),
    ("too_many_steps_between_jumps",
     "subsection Load program\n  set Legs = 0 0 -0.1 : 500 ; 0 0 0 : 500\n  set Cycles = 1000000\n"
     "  set Jump when periodic = 1e-6\n  set Jump cycles = 1\nend\n",
     "{file}: Load program: Preload, Legs and Cycles = 1000000 make 1000000000 load steps, of which at least "
     "500001000 are computed however many cycles are jumped: allowed are 1000000 computed ones"),
    ("too_many_steps_to_count",
     "subsection Load program\n  set Legs = 0 0 -0.1 : 2500 ; 0 0 0 : 2500\n  set Cycles = 1000000\n"
     "  set Jump when periodic = 1e-6\n  set Jump cycles = 1000000\nend\n",
     "{file}: Load program: Preload, Legs and Cycles = 1000000 make 5000000000 load steps: allowed are 4000000000 "
     "where cycles are jumped"),
]
