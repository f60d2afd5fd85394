// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Plain option structs, one for each section of the parameter file. read_parameters() fills them once; they
// are handed on as const references.
#pragma once

#include <orthocone/base/rigid_components.h>
#include <orthocone/body/options.h>
#include <orthocone/contact/law/friction_law.h>
#include <orthocone/contact/solvers/contact_solver_options.h>
#include <orthocone/scene/friction_factor.h>
#include <orthocone/scene/stop_rule.h>
#include <orthocone/scene/wear_kind.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// How a step is solved that wears a node about as deep as pressure flattens it (docs/theory.md, section 3,
/// "Wear").
enum class DeepWear
{
  implicitly, ///< with its depth as an unknown
  explicitly, ///< as any other step: the next one finds the depth
};

template<>
struct Words<DeepWear>
{
  static constexpr std::array<std::pair<DeepWear, std::string_view>, 2> table{
      {{DeepWear::implicitly, "implicit"}, {DeepWear::explicitly, "explicit"}}};
};

/// The word of a kind of obstacle, and those that the program itself has. Others may be added from outside.
struct ObstacleKind
{
  std::string_view word;

  static const ObstacleKind rigid, half_space, body;
};

inline constexpr ObstacleKind ObstacleKind::rigid{"rigid"};
inline constexpr ObstacleKind ObstacleKind::half_space{"half-space"};
inline constexpr ObstacleKind ObstacleKind::body{"body"};

class Obstacle;
struct ObstacleOptions;

/// What a kind of obstacle has of its own: its entries, and the obstacle that they make.
class ObstacleKindOptions
{
public:
  virtual ~ObstacleKindOptions() = default;
  virtual std::unique_ptr<ObstacleKindOptions> clone() const = 0;

  /// Adds the entries of this kind, which count where it is chosen.
  virtual void declare(Section &, const Condition & /*is_chosen*/) {}

  /// Its elastic constants; nothing where it is rigid, or where the scene makes a second body of it.
  virtual std::optional<MaterialOptions> material() const { return std::nullopt; }
  virtual bool is_body() const { return false; }

  /// Whether the obstacle is elastic.
  bool gives_way() const { return is_body() || material(); }

  /// Whether its surface is that of Gap and Gap file alone.
  virtual bool keeps_surface() const { return false; }

  /// The obstacle on the surface that Gap and Gap file make. Throws InputError where entries contradict each
  /// other.
  virtual std::unique_ptr<const Obstacle> make(const ObstacleOptions &options,
                                               std::unique_ptr<const Obstacle> surface) const = 0;
};

template<>
std::vector<Kind<ObstacleKindOptions>> &kinds_of<ObstacleKindOptions>();

/// The word of a kind of friction law, and that of the program itself. Others may be added from outside.
struct FrictionLawKind
{
  std::string_view word;

  static const FrictionLawKind ellipses;
};

inline constexpr FrictionLawKind FrictionLawKind::ellipses{"ellipses"};

struct FrictionOptions;

/// What a kind of friction law has of its own: its entries, and the law that they make at a place.
class FrictionLawOptions
{
public:
  virtual ~FrictionLawOptions() = default;
  virtual std::unique_ptr<FrictionLawOptions> clone() const = 0;

  /// Adds the entries of this kind, which count where it is chosen.
  virtual void declare(Section &, const Condition & /*is_chosen*/) {}

  /// Whether it takes the entries Coefficients and Slip potential.
  virtual bool has_semi_axes() const { return false; }

  /// Whether the law depends on the place.
  virtual bool varies(const FrictionOptions &) const { return false; }

  /// The law at a place (x, y, z) of the contact surface, mm, along its axes of friction. Throws InputError
  /// if there is none.
  virtual FrictionLaw law(const FrictionOptions &friction, const Eigen::Vector3d &place) const = 0;
};

template<>
std::vector<Kind<FrictionLawOptions>> &kinds_of<FrictionLawOptions>();

/// The entries of section Friction: the law, and for that of two ellipses the semi-axes of the friction
/// ellipse (mu) and of the slip ellipse (p). Their first axis is the projection on the tangent plane of x
/// turned by `angle` degrees to y, or of `first_axis`. Where numbers vary, those here are at x = y = z = 0.
struct FrictionOptions
{
  std::array<double, 2> mu{{0.3, 0.15}};                 ///< both 0: no friction
  std::optional<std::array<double, 2>> slip_potential{}; ///< p; without it p = mu, associated friction
  double angle = 0;
  bool is_collinear_by_word = false; ///< p_x = p_y, whatever slip_potential has
  // Values that depend on the place:
  std::optional<std::array<Expression, 2>> varying_mu{};
  std::optional<std::array<Expression, 2>> varying_slip_potential{};
  std::optional<Expression> varying_angle{};
  std::optional<std::array<Expression, 3>> first_axis{}; ///< its projection is the first axis
  Choice<FrictionLawOptions> law{};
  FrictionFactor factor{}; ///< on all coefficients, from step to step

  /// Whether friction has memory.
  bool has_factor() const { return !factor.is_one() && !is_frictionless(); }
  bool has_ellipses() const { return law == FrictionLawKind::ellipses; }
  std::string first_axis_text() const; ///< as the entry has it
  bool varies() const { return varying_angle || first_axis || law.chosen().varies(*this); }
  bool has_semi_axes() const { return law.chosen().has_semi_axes(); }
  bool is_frictionless() const { return has_semi_axes() && mu[0] == 0 && !varying_mu; }

  /// Semi-axes p_x, p_y of the slip ellipse; without friction (1, 1), which means nothing.
  std::array<double, 2> p() const
  {
    return is_frictionless() || is_collinear_by_word ? std::array<double, 2>{{1, 1}}
                                                     : slip_potential.value_or(mu);
  }

  /// Whether p is proportional to mu everywhere, so that slip is along the normal of the cone. False for laws
  /// that are no ellipses.
  bool is_associated() const
  {
    constexpr double rounding = 1e-12;
    const bool has_own_field =
        varying_slip_potential || (varying_mu && (slip_potential || is_collinear_by_word));
    return is_frictionless() ||
           (has_ellipses() && !has_own_field && std::abs(p()[0] * mu[1] / (p()[1] * mu[0]) - 1) <= rounding);
  }

  /// Whether p_x = p_y everywhere, so that slip is along the friction force. False for laws that are no
  /// ellipses.
  bool is_collinear() const
  {
    const bool has_varying_p = varying_slip_potential || (varying_mu && !slip_potential);
    return has_ellipses() && (is_collinear_by_word || (!has_varying_p && p()[0] == p()[1]));
  }

  /// Friction at a place (mm): the same with numbers only. These may be any numbers, also NaN.
  FrictionOptions at(double x, double y, double z = 0) const;
};

/// Which normal the counterface has: z, as the plane below its gap, or that of the body, which it fits.
enum class ObstacleNormal
{
  plane,
  surface,
};

template<>
struct Words<ObstacleNormal>
{
  static constexpr std::array<std::pair<ObstacleNormal, std::string_view>, 2> table{
      {{ObstacleNormal::plane, "plane"}, {ObstacleNormal::surface, "surface"}}};
};

/// The entries of section Obstacle. The gap is the sum of `gap` and of the gap in the file, mm, below the
/// plane z = 0 or along the normals of the body; or it is `distance`.
struct ObstacleOptions
{
  std::string gap = "0";  ///< an Expression
  std::string gap_file{}; ///< path, or empty
  Choice<ObstacleKindOptions> kind{};
  std::string distance{}; ///< an Expression of x, y and z, or empty
  ObstacleNormal normal = ObstacleNormal::plane;

  /// Whether its normal is z everywhere.
  bool has_normal_z() const { return distance.empty() && normal == ObstacleNormal::plane; }

  /// Whether the surface of the obstacle is the plane z = 0.
  bool is_plane() const;
};

/// The entries of section Wear.
struct WearOptions
{
  Choice<WearKindOptions> law{};
  double coefficient = 0; ///< worn mm^3 per N mm of normal force times slip, or of friction work; 1/MPa
  DeepWear deep_steps = DeepWear::implicitly;
  double largest_jump = 0; ///< largest depth that cycles may wear off without being computed, mm; 0 = none

  bool wears() const { return law.chosen().wears(); }
  std::string law_entry() const { return "Wear/Law = " + law.word(); }
};

/// The target of a component of the held face in a leg: mm, degrees, N or N mm.
struct Drive
{
  bool by_force = false;
  double value = 0;

  bool operator==(const Drive &other) const { return by_force == other.by_force && value == other.value; }
};

/// Where a leg of a program file stands in its signal.
struct SignalRow
{
  unsigned int line = 0;        ///< of the file, from 1
  std::optional<double> time{}; ///< at the end of the leg, s
  unsigned int cycle = 0;       ///< counted from 1; 0 before the first one
  bool ends_cycle = false;
};

/// One leg of the load program. The components that it names (ux uy uz rx ry rz, or in their place Fx Fy Fz
/// Mx My Mz) and the loads go to their targets on a straight line in equal steps; the others stay as they
/// are.
struct Leg
{
  std::array<std::optional<Drive>, n_rigid_components> targets{};
  unsigned int steps = 1;
  unsigned int parts = 1; ///< of each step, solved one by one; only the step's end is checked and written
  std::optional<SignalRow> row{};                      ///< of a leg of the program file
  std::vector<std::pair<std::string, double>> loads{}; ///< names and targets of loads, in their units

  /// The target of the load of this name, or nothing.
  std::optional<double> load(const std::string &name) const
  {
    for (const auto &[own, target] : loads)
      if (own == name)
        return target;
    return std::nullopt;
  }

  /// Where the leg moves the component (mm or degrees), or nothing if it does not.
  std::optional<double> motion(const unsigned int component) const
  {
    const auto &target = targets[component];
    return target && !target->by_force ? std::optional<double>(target->value) : std::nullopt;
  }
  bool operator==(const Leg &other) const
  {
    return targets == other.targets && steps == other.steps && parts == other.parts && loads == other.loads;
  }
};

/// A leg that moves the held face to (ux, uy, uz), mm.
inline Leg move_to(const double ux, const double uy, const double uz, const unsigned int steps)
{
  return {{{Drive{false, ux}, Drive{false, uy}, Drive{false, uz}}}, steps};
}

/// The largest number of steps of a load program, each counted with all its parts.
constexpr double most_solved_parts = 1e6;

/// The entries of section Load program: the preload once, then the legs `cycles` times.
struct LoadOptions
{
  std::vector<Leg> preload;
  std::vector<Leg> legs{move_to(0, 0, -0.1, 5), move_to(0, 0, 0, 10)}; ///< the paper's cycle
  unsigned int cycles = 1;
  double accuracy =
      0; ///< wanted of `quantity_names` as far as load steps cause errors, percent; 0: steps as given
  std::string program_file{};         ///< path, or empty; its rows take the place of `legs`
  unsigned int steps_per_row = 1;     ///< load steps of each row of that file
  std::vector<Leg> rows{};            ///< of that file: read_program_file()
  Kinds<StopRule> stops{};            ///< each of which may end the run before its last cycle
  double jump_when_periodic = 0;      ///< bound of the change of state in a cycle; 0 = never
  unsigned int jump_cycles = 100;     ///< most cycles that are jumped before the next one is computed
  double jump_change_of_friction = 0; ///< relative, of a node in cycles that are jumped; 0 = none
  std::vector<Load> loads{};          ///< beside the held face, on both bodies

  /// The legs that are passed through `cycles` times.
  const std::vector<Leg> &cycle_legs() const { return program_file.empty() ? legs : rows; }

  unsigned int first_cycle() const { return preload.empty() ? 1 : 0; } ///< of the first step

  /// The number of complete cycles: those that were found in the program file, or `cycles`.
  unsigned int n_cycles() const;
};

/// The entries of section Checks: bounds of the independent checks of every step (docs/theory.md, section 5).
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

/// A straight line in the whole body or on its contact surface, along which fields are written.
struct Line
{
  std::string name;
  std::array<double, 3> from{{0, 0, 0}}, to{{0, 0, 0}}; ///< mm
  unsigned int n_points = 2;

  double length() const { return std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]); } ///< mm

  /// Point i of n_points, mm; the first and the last one are the ends, without rounding.
  std::array<double, 3> point(const unsigned int i) const
  {
    const double share = static_cast<double>(i) / (n_points - 1);
    std::array<double, 3> place{};
    for (unsigned int d = 0; d < 3; ++d)
      place[d] = (1 - share) * from[d] + share * to[d];
    return place;
  }
};

/// The entries of section Output. Intervals are numbers of steps; 0 = never.
struct OutputOptions
{
  unsigned int contact_interval = 1;
  unsigned int volume_interval = 0;
  unsigned int problem_interval = 0;
  double checkpoint_seconds = 2; ///< least time between two checkpoints; 0 = one after every step
  std::vector<Probe> probes;
  unsigned int line_interval = 1;
  std::vector<Line> lines{};
};

/// The whole parameter file: the body, and what it is pressed on and how. The lower body, which is there with
/// `Obstacle/Kind = body`, is described as if it stood on a plane; its mirror image is below z = 0, and its
/// held face does not move (docs/theory.md, section 2, "A second elastic body below").
struct Parameters : BodyOptions
{
  FrictionOptions friction;
  ObstacleOptions obstacle;
  BodyOptions lower = BodyOptions::lower();
  WearOptions wear;
  LoadOptions load;
  ContactSolverOptions contact_solver;
  CheckOptions checks;
  OutputOptions output;
};

// Each adds the entries of a section.
void declare_friction(FrictionOptions &friction, Section &section);
void declare_obstacle(ObstacleOptions &obstacle, Section &section);
void declare_wear(WearOptions &wear, Section &section);
void declare_load(LoadOptions &load, Section &section);
void declare_contact_solver(ContactSolverOptions &solver, Section &section);
void declare_checks(CheckOptions &checks, Section &section);
void declare_output(OutputOptions &output, Section &section);

/// Throws InputError for a program without legs, or with more steps than can be computed or counted.
void check_load(const LoadOptions &load, const WearOptions &wear);

/// Throws InputError where a wear law contradicts other entries.
void check_wear(const WearOptions &wear, const LoadOptions &load);

/// Adds warnings of bounds for a periodic response that rounding hides, or that are loose.
void warn_of_periods(const LoadOptions &load, double tolerance, std::vector<std::string> &warnings);

/// Adds a warning where the method is there for study only.
void warn_of_weak_method(const ContactSolverOptions &solver, std::vector<std::string> &warnings);
} // namespace orthocone
