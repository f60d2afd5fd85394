// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Plain option structs, one per section of the parameter file. They are filled once by read_parameters() and
// handed on as const references. No library header is needed to read them.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// How the upper face is held: clamped (moves as a rigid plate) or guided (u_z prescribed, free sideways).
enum class TopFace
{
  clamped,
  guided,
};

/// Part of the cylinder that is modelled; axisymmetric is its section (r, z).
enum class ModelKind
{
  automatic,
  full,
  half,
  quarter,
  axisymmetric,
};

/// Who chooses the cells of the mesh: the single entries (custom), or one word for all of them.
enum class MeshResolution
{
  custom,
  paper,
  coarse,
  medium,
  fine,
};

/// How the part of the stiffness that resists changes of volume is integrated: like the rest (full), or so
/// that it sees the divergence one degree lower (reduced).
enum class VolumetricQuadrature
{
  full,
  reduced,
};

/// Contact solvers.
enum class ContactMethod
{
  newton,
  gauss_seidel,
  uzawa,
  feng2006,
  box3,
  plain_newton,
};

/// Section Geometry (mm).
struct GeometryOptions
{
  double radius = 10;
  double height = 10;
  TopFace top_face = TopFace::clamped;
};

/// Section Mesh: an o-grid disc extruded into layers.
struct MeshOptions
{
  ModelKind model = ModelKind::automatic;
  unsigned int core_cells = 8;        ///< cells along a side of the core block
  unsigned int rings = 0;             ///< cells from core to rim; 0: as many as core cells
  unsigned int layers = 4;            ///< cells over the height
  unsigned int degree = 2;            ///< polynomial degree of FE_Q
  unsigned int quadrature_points = 0; ///< Gauss points per direction; 0: degree + 1
  VolumetricQuadrature volumetric_quadrature = VolumetricQuadrature::full;
  double core_ratio = 0.5;  ///< core corner radius / R
  double rim_grading = 1;   ///< thickness of a ring / thickness of the next inner ring
  double layer_grading = 1; ///< thickness of a layer / thickness of its neighbour towards mid-height
  MeshResolution resolution = MeshResolution::custom;
  double accuracy = 0; ///< wanted of the four quantities that users look at, percent; 0: the mesh is given

  unsigned int n_rings() const { return rings == 0 ? core_cells : rings; }
  unsigned int n_quadrature_points() const { return quadrature_points == 0 ? degree + 1 : quadrature_points; }
};

/// Section Material: isotropic linear elasticity.
struct MaterialOptions
{
  double young_modulus = 210000; ///< MPa
  double poisson_ratio = 0.3;
};

/// Section Friction: semi-axes of the friction ellipse (mu) and of the slip ellipse (p), both along axes
/// turned by `angle` degrees from x to y.
struct FrictionOptions
{
  std::array<double, 2> mu{{0.3, 0.15}};                 ///< both 0: no friction
  std::optional<std::array<double, 2>> slip_potential{}; ///< p; without it p = mu, associated friction
  double angle = 0;

  bool is_frictionless() const { return mu[0] == 0; }

  /// Semi-axes of the slip ellipse; (1, 1), which means nothing, without friction.
  std::array<double, 2> p() const
  {
    return is_frictionless() ? std::array<double, 2>{{1, 1}} : slip_potential.value_or(mu);
  }
  bool is_associated() const
  {
    constexpr double rounding = 1e-12;
    return is_frictionless() || std::abs(p()[0] * mu[1] / (p()[1] * mu[0]) - 1) <= rounding;
  }
  bool is_collinear() const { return p()[0] == p()[1]; }
};

/// One leg of the load program: the top moves on a straight line to `target` (ux, uy, uz in mm) in equal
/// steps.
struct Leg
{
  std::array<double, 3> target{{0, 0, 0}};
  unsigned int steps = 1;
};

/// Section Load program: the preload once, then the legs `cycles` times.
struct LoadOptions
{
  std::vector<Leg> preload;
  std::vector<Leg> legs{{{{0, 0, -0.1}}, 5}, {{{0, 0, 0}}, 10}}; ///< the paper's cycle
  unsigned int cycles = 1;
  double stop_when_periodic = 0;  ///< bound of the change of state in a cycle; 0 = never
  double jump_when_periodic = 0;  ///< bound of the change of state in a cycle; 0 = never
  unsigned int jump_cycles = 100; ///< most cycles that are jumped before another one is computed
};

/// Section Contact solver.
struct ContactSolverOptions
{
  ContactMethod method = ContactMethod::newton;
  double tolerance = 1e-10;               ///< bound of the relative natural-map residual
  unsigned int maximum_iterations = 5000; ///< sweeps or iterations of one step
  double relaxation = 1;                  ///< of the sweeps: share of the one-node solution that is taken
  double rho_factor = 1;                  ///< of the methods that have a rho of their own
};

/// Section Checks: bounds of the independent checks of every step.
struct CheckOptions
{
  double equilibrium = 1e-8; ///< relative, forces of the body and displacements of its contact surface
  double penetration = 1000; ///< this one and the next three: in multiples of the solver's tolerance
  double complementarity = 1000;
  double friction_cone = 1000;
  double slip_rule = 1000;
  double energy_identity = 1e-8; ///< relative to the largest energy so far
  double energy_defect = 2;      ///< relative to the largest energy so far
};

/// A point of the contact surface whose history is written.
struct Probe
{
  std::string name;
  std::array<double, 2> position{{0, 0}}; ///< mm
};

/// Section Output; intervals of the fields in steps, 0 = never.
struct OutputOptions
{
  unsigned int contact_interval = 1;
  unsigned int volume_interval = 0;
  double checkpoint_seconds = 2; ///< least time between two checkpoints; 0 = one after every step
  std::vector<Probe> probes;
};

/// The whole parameter file.
struct Parameters
{
  GeometryOptions geometry;
  MeshOptions mesh;
  MaterialOptions material;
  FrictionOptions friction;
  LoadOptions load;
  ContactSolverOptions contact_solver;
  CheckOptions checks;
  OutputOptions output;
};
} // namespace orthocone
