// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "declare.h"

#include "solver_entries.h"

namespace orthocone
{
using namespace entries;

namespace
{
void declare_shape(GeometryOptions &geometry, EntryTable &table)
{
  add_choice(table, "Shape", geometry.shape,
             "Shape of the body; its base z = 0 rests on the rigid plane, its axis is z.");
  add_number(table, "Radius", geometry.radius, positive, "Radius of a cylinder in mm.");
  add_number(table, "Height", geometry.height, positive, "Height of a cylinder in mm.");
  add_sizes(table, "Sizes", geometry.sizes, "l_x, l_y, l_z: lengths of a box along the axes in mm.");
  add_path(table, "Mesh file", geometry.mesh_file,
           "Of a file: a mesh of hexahedra by Gmsh (format 2.1, 2.2 or 4.1, ASCII, mm), relative to the "
           "folder of the parameter file. It has the modelled part of the body, and all of its base is at z "
           ">= 0: the height of a node of the base is its gap.");
  add_group(table, "Contact surface", geometry.contact_surface,
            "Of a file: surface that is pressed on the plane: a physical one, or a place such as z min.");
  add_group(table, "Held surface", geometry.held_surface,
            "Of a file: surface that moves as a rigid one, of any shape, by its name or place (z max).");
  add_groups(table, "Symmetry surfaces", geometry.symmetry_surfaces,
             "Of a file: surfaces in x = 0 or y = 0, by names or places, about which the body is symmetric.");
}

void declare_geometry(GeometryOptions &geometry, EntryTable &table)
{
  declare_shape(geometry, table);
  add_choice(
      table, "Top face", geometry.top_face,
      "The upper face moves as a rigid plate (clamped), or has u_z prescribed and is free sideways (guided; "
      "only in a quarter or axisymmetric model, where symmetry holds the body).");
}

void declare_mesh(MeshOptions &mesh, EntryTable &table)
{
  add_choice(table, "Model", mesh.model,
             "Part of the body that is modelled; auto takes the smallest that is exact for the scene. "
             "axisymmetric: "
             "its section (r, z), with the cells that lie along the x axis.");
  add_choice(table, "Resolution", mesh.resolution,
             "paper: the mesh of the paper's figures; coarse, medium, fine: degree 3 (4 if axisymmetric) and "
             "cells that shrink "
             "towards the rim, the base and the upper face (docs/accuracy.md: what each reaches and costs); "
             "custom: the entries below. With another word than custom these stay at their defaults.");
  add_percentage(
      table, "Accuracy", mesh.accuracy, Range{0.01, 50, true, true},
      "Largest wanted error of the largest slip, the total force, the dissipated energy and the stick area: "
      "the program refines the mesh until it estimates to have reached it; Resolution and the entries below "
      "then stay at their defaults. 0 = the mesh is given.");
}

void declare_cells(MeshOptions &mesh, EntryTable &table)
{
  add_count(table, "Core cells", mesh.core_cells, 1, 200, "Cells along a side of the core block.");
  add_count(table, "Rings", mesh.rings, 0, 200, "Cells from core to rim; 0 = as many as core cells.");
  add_count(table, "Layers", mesh.layers, 1, 200, "Cells over the height.");
  add_count(table, "Degree", mesh.degree, 1, 4,
            "Polynomial degree of the elements; 4 in the axisymmetric model only.");
  add_count(table, "Quadrature points", mesh.quadrature_points, 0, 10,
            "Gauss points per direction, more than the degree; 0 = degree + 1.");
  add_choice(
      table, "Volumetric quadrature", mesh.volumetric_quadrature,
      "projected: the elements resist changes of volume only as far as these are polynomials of the degree "
      "- 1 (B-bar for degree 1), so that nearly incompressible bodies do not lock and contact stresses do "
      "not "
      "scatter; full: as far as they go; auto: projected for degree 2 and more, full for degree 1. reduced "
      "is "
      "an older word for projected. May stand beside a Resolution or an Accuracy.");
  add_number(table, "Core ratio", mesh.core_ratio, Range{0.01, 1, true, false},
             "Distance of the core's corners from the axis / radius.");
  add_number(table, "Rim grading", mesh.rim_grading, Range{0, 10, false, true},
             "Each ring is this many times as thick as the next inner one; 1 = uniform.");
  add_cells(table, "Cells", mesh.cells, 200, "n_x, n_y, n_z: cells of a box along the axes.");
  add_number(
      table, "Edge grading", mesh.edge_grading, Range{0, 10, false, true},
      "Of a box: each cell is this many times as thick as its neighbour towards the middle; 1 = uniform.");
  add_number(table, "Layer grading", mesh.layer_grading, Range{0, 10, false, true},
             "Each layer is this many times as thick as its neighbour towards mid-height; 1 = uniform.");
}

void declare_refinements(MeshOptions &mesh, EntryTable &table)
{
  add_count(table, "Refinements", mesh.refinements, 0, 7,
            "How often all these cells are halved in every direction.");
}

void declare_backend(MeshOptions &mesh, EntryTable &table)
{
  add_count(
      table, "Adaptive", mesh.adaptive, 0, 10,
      "Rounds in which cells are halved where the first cycle, solved on the mesh so far, shows that they "
      "are too large: at the rim of the base, where stick, slip and gap meet, and where stresses jump "
      "between cells.");
  add_refined_cells(
      table, "Refined cells", mesh.refined_cells,
      "Cells of the modelled part that are halved beside these, round by round; what Adaptive has chosen.");
  add_choice(
      table, "Backend", mesh.backend,
      "How the elastic body is solved: factorized and condensed to its contact nodes (condensed), or by "
      "multigrid over all these meshes, without a factorization of the whole (multigrid: solids of degree 1 "
      "to 3 with Contact solver/Method = newton). auto: what takes less time by an estimate, or alone fits "
      "into the memory; condensed where no cell is halved and that takes seconds. May stand beside a "
      "Resolution or an Accuracy.");
}

void declare_material(MaterialOptions &material, EntryTable &table)
{
  add_number(table, "Young modulus", material.young_modulus, positive, "Young's modulus in MPa.");
  add_number(table, "Poisson ratio", material.poisson_ratio, Range{-1, 0.5}, "Poisson's ratio.");
  add_choice(table, "Law", material.law,
             "isotropic: the two constants above; orthotropic: the nine below, along x, y and z.");
  add_sizes(table, "Young moduli", material.young_moduli, "E_x, E_y, E_z in MPa.");
  add_triple(table, "Poisson ratios", material.poisson_ratios,
             "nu_xy, nu_xz, nu_yz: under stress along x alone nu_xy = -strain along y / strain along x.");
  add_sizes(table, "Shear moduli", material.shear_moduli, "G_xy, G_xz, G_yz in MPa.");
  add_regions(table, "Regions", material.regions,
              "Other, isotropic constants of physical volumes of a Mesh file: 'name: E, nu ; ...'.");
}

void declare_friction(FrictionOptions &friction, EntryTable &table)
{
  add_coefficients(
      table, "Coefficients", friction,
      "mu_x, mu_y: semi-axes of the friction ellipse, the section of the cone at unit normal force.");
  add_slip_potential(
      table, "Slip potential", friction,
      "p_x, p_y: semi-axes of the slip ellipse; only their ratio matters. associated: those of the friction "
      "ellipse, so that slip is normal to it. Equal ones, or collinear: slip is along the force.");
  add_angle(
      table, "Orthotropy angle", friction,
      "Degrees from the x axis to the first axis of both ellipses; atan2(y,x)*180/pi: axes along radius "
      "and hoop.");
}

void declare_obstacle(ObstacleOptions &obstacle, EntryTable &table)
{
  add_gap(table, "Gap", obstacle.gap,
          "Gap between the base of the body and the obstacle in mm, before the body moves, such as "
          "(x^2+y^2)/(2*1000), a sphere of radius 1000 mm.");
  add_path(
      table, "Gap file", obstacle.gap_file,
      "A gap on a regular grid, which is added to Gap: a text file with the line 'x0 dx nx y0 dy ny', then "
      "ny lines of nx numbers, mm; relative to the folder of the parameter file.");
  add_choice(
      table, "Kind", obstacle.kind,
      "What the body rests on: a rigid plane, an elastic half-space (needs no mesh), or a second elastic "
      "body, that of the sections Lower geometry, Lower mesh and Lower material (neither in the "
      "axisymmetric model, nor with Mesh/Backend = multigrid). Gap is that between both, whichever of them "
      "is curved.");
  const std::string of_half_space = " of a half-space; without one it has no meaning.";
  add_number(table, "Young modulus", obstacle.material.young_modulus, positive,
             "Young's modulus in MPa" + of_half_space);
  add_number(table, "Poisson ratio", obstacle.material.poisson_ratio, Range{-1, 0.5},
             "Poisson's ratio" + of_half_space);
}

void declare_wear(WearOptions &wear, EntryTable &table)
{
  add_choice(table, "Law", wear.law,
             "What wears the base of the body where it slips, a depth that is added to the gap. archard: "
             "Coefficient x pressure x slip; energy: Coefficient x dissipated energy per area.");
  add_number(table, "Coefficient", wear.coefficient, Range{0, 1e6, true, true},
             "Volume that is worn per work, mm^3/(N mm) = 1/MPa; above 0 where a Law wears.");
  add_choice(table, "Deep steps", wear.deep_steps,
             "How a step is solved that wears a node more than 0.9 times as deep as pressure flattens it: "
             "implicit, with the depth as an unknown, so that a stroke may be far longer than the contact "
             "(explicit with Mesh/Backend = multigrid); explicit, the next step finds the depth, and contact "
             "flickers from node to node.");
  add_number(
      table, "Largest depth of a jump", wear.largest_jump, Range{0, 1e6, true, true},
      "Cycles are jumped, each as the last one, as long as no node loses more than this depth in mm; "
      "fewer where the depth of a cycle changes by more than a tenth from jump to jump. 0 = all cycles "
      "are computed.");
}

void declare_load(LoadOptions &load, EntryTable &table)
{
  add_legs(table, "Preload", load.preload, "Legs passed through once, before the cycles.");
  add_legs(
      table, "Legs", load.legs,
      "Legs of a cycle: the upper face moves to (ux, uy, uz) in equal steps, from where it was. Named "
      "components, as in 'Fz -2e5 rz 0.5 : 10', are driven by a motion or by a force; the others keep "
      "what they have. ': 10 * 4' solves each of 10 steps in 4 parts, of which only the last is written.");
  add_percentage(
      table, "Accuracy", load.accuracy, Range{0.01, 50, true, true},
      "Largest wanted error by the size of the load steps, of the quantities of Mesh/Accuracy and of the "
      "work "
      "of the upper face in the first cycle: the program divides the steps of each leg into as many parts as "
      "it estimates to need. States are written at the steps of the legs. 0 = the legs are taken as they "
      "are.");
  add_count(table, "Cycles", load.cycles, 0, 1000000, "How many times the legs are passed through.");
  const Range share{0, 1, true, false};
  add_number(
      table, "Stop when periodic", load.stop_when_periodic, share,
      "The run is complete as soon as a cycle ends as it began: nodal forces within this share of the "
      "largest one, displacements within this share of the largest motion of the upper face; 0 = never.");
  add_number(
      table, "Jump when periodic", load.jump_when_periodic, share,
      "When a cycle ends as it began, in the same measure, the next ones are not computed: accumulated "
      "slip and dissipated energy grow as in this one; 0 = never. The last cycle is always computed.");
  add_count(table, "Jump cycles", load.jump_cycles, 1, 1000000,
            "Most cycles that are jumped before another one is computed, which shows whether the response is "
            "still periodic.");
}

void declare_contact_solver(ContactSolverOptions &solver, EntryTable &table)
{
  add_contact_method(table, "Method", solver.method);
  add_number(table, "Tolerance", solver.tolerance, Range{1e-14, 1, true, false},
             "Bound of the natural-map residual relative to the contact forces.");
  add_count(table, "Maximum iterations", solver.maximum_iterations, 1, 10000000,
            "Sweeps or iterations for one load step, for each part of one that has to be halved, and, on "
            "multigrid, "
            "for each slip rule on the way to one that is far from associated.");
  add_number(table, "Relaxation", solver.relaxation, Range{0, 2},
             "Relaxation factor of the sweeps of gauss-seidel: 1 takes the one-node solutions as they are.");
  add_rho_factor(table, "Rho factor", solver.rho_factor);
}

void declare_checks(CheckOptions &checks, EntryTable &table)
{
  const std::string times = " Bound in multiples of Contact solver/Tolerance.";
  add_number(
      table, "Equilibrium", checks.equilibrium, positive,
      "Every step is checked from its final state; one that exceeds a bound stops the run (exit code 3). "
      "Bound of the forces in the body that contact forces do not balance, relative to these, and of the "
      "difference between the displacements of body and contact surface.");
  add_number(table, "Penetration", checks.penetration, positive,
             "Largest negative gap relative to the largest displacement." + times);
  add_number(table, "Complementarity", checks.complementarity, positive,
             "Gap and normal force, each relative to its largest: the smaller of both must vanish." + times);
  add_number(table, "Friction cone", checks.friction_cone, positive,
             "Largest ||r_t||_m - r_n relative to the largest force." + times);
  add_number(
      table, "Slip rule", checks.slip_rule, positive,
      "Change of slip that is not along the normal of the slip ellipse, or not on the cone, weighted with "
      "the normal force." +
          times);
  add_number(
      table, "Energy identity", checks.energy_identity, positive,
      "Work of the upper face minus change of elastic energy minus work of the mean contact forces, and "
      "dissipation that these cannot do, relative to the largest energy or work of a step so far. It holds "
      "for steps of any size.");
  add_number(
      table, "Energy defect", checks.energy_defect, positive,
      "Work of the upper face minus change of elastic energy minus dissipation in a step, relative to the "
      "largest energy or work of a step so far. It falls with the square of the steps: a step in which all "
      "slips back reaches 1, and its loop is not to be trusted; above 0.05 there is a warning.");
}

void declare_output(OutputOptions &output, EntryTable &table)
{
  add_count(table, "Contact fields", output.contact_interval, 0, 1000000,
            "Every how many steps the fields on the contact surface are written; 0 = never.");
  add_count(table, "Volume fields", output.volume_interval, 0, 1000000,
            "Every how many steps displacement and stress of the body are written; 0 = never.");
  add_count(table, "Problems", output.problem_interval, 0, 1000000,
            "Every how many steps the contact problem is written with its solution, in FCLIB's format; 0 = "
            "never. A step that is not solved leaves its problem, too. For condensed solids, and a program "
            "that was built with FCLIB.");
  add_number(table, "Checkpoint", output.checkpoint_seconds, Range{0, 1e9, true, true},
             "Least seconds between two checkpoints, from which --resume goes on; 0 = one after every step.");
  add_probes(table, "Probes", output.probes,
             "Points of the contact surface whose history is written; the nearest contact node is taken.");
}
} // namespace

void declare_parameters(Parameters &parameters, EntryTable &table)
{
  const auto section = [&table](const char *const name, auto declare, auto &options)
  {
    table.enter(name);
    declare(options, table);
  };
  section("Geometry", declare_geometry, parameters.geometry);
  section("Mesh", declare_mesh, parameters.mesh);
  section("Mesh", declare_cells, parameters.mesh);
  section("Mesh", declare_refinements, parameters.mesh);
  section("Mesh", declare_backend, parameters.mesh);
  section("Material", declare_material, parameters.material);
  section("Friction", declare_friction, parameters.friction);
  section("Obstacle", declare_obstacle, parameters.obstacle);
  section("Lower geometry", declare_shape, parameters.lower.geometry);
  section("Lower mesh", declare_cells, parameters.lower.mesh);
  section("Lower mesh", declare_refinements, parameters.lower.mesh);
  section("Lower material", declare_material, parameters.lower.material);
  section("Wear", declare_wear, parameters.wear);
  section("Load program", declare_load, parameters.load);
  section("Contact solver", declare_contact_solver, parameters.contact_solver);
  section("Checks", declare_checks, parameters.checks);
  section("Output", declare_output, parameters.output);
}
} // namespace orthocone
