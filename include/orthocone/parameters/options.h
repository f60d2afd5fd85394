// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Plain option structs, one per section of the parameter file. They are filled once by read_parameters() and
// handed on as const references. No library header is needed to read them.
#pragma once

#include <orthocone/base/contact_solver_options.h>
#include <orthocone/base/rigid_components.h>
#include <orthocone/parameters/expression.h>

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

/// Shape of the body.
enum class BodyShape
{
  cylinder,
  box,
  file,
};

/// Part of the body that is modelled; axisymmetric is its section (r, z).
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

/// What the body rests on.
enum class ObstacleKind
{
  rigid,
  half_space,
};

/// Law of elasticity of the body.
enum class MaterialLaw
{
  isotropic,
  orthotropic,
};

/// How the elastic body is solved: factorized and condensed to its contact nodes, or by multigrid.
enum class BodyBackend
{
  automatic,
  condensed,
  multigrid,
};

/// What takes material off the base of the body where it slips.
enum class WearKind
{
  none,
  archard,
  energy,
};

/// Section Geometry (mm).
struct GeometryOptions
{
  double radius = 10;
  double height = 10;
  TopFace top_face = TopFace::clamped;
  BodyShape shape = BodyShape::cylinder;
  std::array<double, 3> sizes{{20, 20, 10}}; ///< of a box, along x, y, z
  std::string mesh_file{};                   ///< path, or empty
  // Physical groups of that file, by name or number:
  std::string contact_surface{};
  std::string held_surface{};
  std::vector<std::string> symmetry_surfaces{};

  bool is_from_file() const { return shape == BodyShape::file; }

  /// Distance of the held face from the base; not of a body from a file.
  double held_height() const { return shape == BodyShape::box ? sizes[2] : height; }
};

/// Cells of a mesh from `first` to `last`, numbers in its order.
struct CellRange
{
  unsigned int first, last;
};

/// Section Mesh: an o-grid disc extruded into layers, or the rows of cells of a box.
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
  std::array<unsigned int, 3> cells{{8, 8, 4}}; ///< of a box, along x, y, z
  double edge_grading = 1;      ///< of a box: thickness of a cell / that of its neighbour towards the middle
  unsigned int refinements = 0; ///< how often every cell is divided into eight, a section's into four
  BodyBackend backend = BodyBackend::automatic;
  unsigned int adaptive = 0; ///< rounds of refinement where the first cycle asks for it
  std::vector<std::vector<CellRange>> refined_cells{}; ///< halved after all refinements, round by round
  unsigned int coarsenings = 0; ///< how often cells that were halved are made larger again; no entry

  unsigned int n_rings() const { return rings == 0 ? core_cells : rings; }
  unsigned int n_quadrature_points() const { return quadrature_points == 0 ? degree + 1 : quadrature_points; }
};

/// Isotropic constants of a volume of an imported mesh.
struct MaterialRegion
{
  std::string volume;   ///< name or number of the physical group
  double young_modulus; ///< MPa
  double poisson_ratio;
};

/// Section Material: linear elasticity.
struct MaterialOptions
{
  double young_modulus = 210000; ///< MPa
  double poisson_ratio = 0.3;
  MaterialLaw law = MaterialLaw::isotropic;
  // Of the orthotropic law:
  std::array<double, 3> young_moduli{{210000, 210000, 210000}}; ///< E_x, E_y, E_z, MPa
  std::array<double, 3> poisson_ratios{{0.3, 0.3, 0.3}};        ///< nu_xy, nu_xz, nu_yz
  std::array<double, 3> shear_moduli{{80000, 80000, 80000}};    ///< G_xy, G_xz, G_yz, MPa
  std::vector<MaterialRegion> regions{};

  bool is_orthotropic() const { return law == MaterialLaw::orthotropic; }
  bool is_uniform_and_isotropic() const { return !is_orthotropic() && regions.empty(); }

  /// The constants themselves, or, where the law is orthotropic, isotropic ones of its size: for estimates.
  MaterialOptions isotropic() const;
};

/// Section Friction: semi-axes of the friction ellipse (mu) and of the slip ellipse (p), both along axes
/// turned by `angle` degrees from x to y. The numbers are those of the centre x = y = 0 where they vary.
struct FrictionOptions
{
  std::array<double, 2> mu{{0.3, 0.15}};                 ///< both 0: no friction
  std::optional<std::array<double, 2>> slip_potential{}; ///< p; without it p = mu, associated friction
  double angle = 0;
  bool is_collinear_by_word = false; ///< p_x = p_y, whatever slip_potential has
  // What depends on the place.
  std::optional<std::array<Expression, 2>> varying_mu{};
  std::optional<std::array<Expression, 2>> varying_slip_potential{};
  std::optional<Expression> varying_angle{};

  bool varies() const { return varying_mu || varying_slip_potential || varying_angle; }
  bool is_frictionless() const { return mu[0] == 0 && !varying_mu; }

  /// Semi-axes of the slip ellipse; (1, 1), which means nothing, without friction.
  std::array<double, 2> p() const
  {
    return is_frictionless() || is_collinear_by_word ? std::array<double, 2>{{1, 1}}
                                                     : slip_potential.value_or(mu);
  }
  bool is_associated() const
  {
    constexpr double rounding = 1e-12;
    const bool has_own_field =
        varying_slip_potential || (varying_mu && (slip_potential || is_collinear_by_word));
    return is_frictionless() ||
           (!has_own_field && std::abs(p()[0] * mu[1] / (p()[1] * mu[0]) - 1) <= rounding);
  }
  bool is_collinear() const
  {
    const bool has_varying_p = varying_slip_potential || (varying_mu && !slip_potential);
    return is_collinear_by_word || (!has_varying_p && p()[0] == p()[1]);
  }

  /// Friction at a place (mm): the same with numbers alone, which may be any, also NaN.
  FrictionOptions at(double x, double y) const;
};

/// Section Obstacle: the gap between the plane z = 0 and the obstacle is `gap` and that of the file, mm.
struct ObstacleOptions
{
  std::string gap = "0";  ///< an Expression
  std::string gap_file{}; ///< path, or empty
  ObstacleKind kind = ObstacleKind::rigid;
  MaterialOptions material{}; ///< of a half-space

  /// Whether it is the plane z = 0.
  bool is_plane() const;
};

/// Section Wear.
struct WearOptions
{
  WearKind law = WearKind::none;
  double coefficient = 0; ///< mm^3 that are worn by 1 N mm: of normal force times slip, or of friction; 1/MPa
  double largest_jump = 0; ///< largest depth that cycles without computing them may wear off, mm; 0 = none
};

/// What a leg does to a component of the motion of the held face: mm, degrees, N or N mm.
struct Drive
{
  bool by_force = false;
  double value = 0;

  bool operator==(const Drive &other) const { return by_force == other.by_force && value == other.value; }
};

/// One leg of the load program: the components that it names (ux uy uz rx ry rz, or Fx Fy Fz Mx My Mz of the
/// same place) go to their targets on a straight line in equal steps; the others stay as they are.
struct Leg
{
  std::array<std::optional<Drive>, n_rigid_components> targets{};
  unsigned int steps = 1;
  unsigned int parts = 1; ///< in which each of them is solved; only its end is checked and written

  /// Where the leg moves the component to (mm or degrees), if it does.
  std::optional<double> motion(const unsigned int component) const
  {
    const auto &target = targets[component];
    return target && !target->by_force ? std::optional<double>(target->value) : std::nullopt;
  }
  bool operator==(const Leg &other) const
  {
    return targets == other.targets && steps == other.steps && parts == other.parts;
  }
};

/// A leg that moves the held face to (ux, uy, uz), mm.
inline Leg move_to(const double ux, const double uy, const double uz, const unsigned int steps)
{
  return {{{Drive{false, ux}, Drive{false, uy}, Drive{false, uz}}}, steps};
}

/// Most steps of a load program, each with all its parts.
constexpr double most_solved_parts = 1e6;

/// Section Load program: the preload once, then the legs `cycles` times.
struct LoadOptions
{
  std::vector<Leg> preload;
  std::vector<Leg> legs{move_to(0, 0, -0.1, 5), move_to(0, 0, 0, 10)}; ///< the paper's cycle
  unsigned int cycles = 1;
  double accuracy = 0; ///< wanted of what users look at, as far as load steps err, percent; 0: as given
  double stop_when_periodic = 0;  ///< bound of the change of state in a cycle; 0 = never
  double jump_when_periodic = 0;  ///< bound of the change of state in a cycle; 0 = never
  unsigned int jump_cycles = 100; ///< most cycles that are jumped before another one is computed
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
  ObstacleOptions obstacle;
  WearOptions wear;
  LoadOptions load;
  ContactSolverOptions contact_solver;
  CheckOptions checks;
  OutputOptions output;
};
} // namespace orthocone
