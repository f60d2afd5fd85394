// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/scene/load_path.h>
#include <orthocone/scene/parameters.h>

#include <cmath>
#include <limits>

namespace orthocone
{
namespace
{
void warn_of_slip_ellipse(const FrictionOptions &friction, std::vector<std::string> &warnings)
{
  constexpr double most = 20;
  if (!friction.has_ellipses())
    return;
  const double ratio = friction.p()[0] / friction.p()[1];
  if (std::max(ratio, 1 / ratio) > most)
    warnings.push_back(
        "Friction/Slip potential = " + to_text(friction.p()[0]) + ", " + to_text(friction.p()[1]) +
        ": the axes differ more than 20-fold, so that nodes slip along one axis only, whatever the force, "
        "and the contact solver may need many iterations; axes nearer to each other avoid this");
}

/// Whether a force or a tilt of the held face, or a load, may press it down where u_z does not.
bool presses_otherwise(const Leg &leg)
{
  if (!leg.loads.empty())
    return true;
  const auto is_nonzero = [&](const unsigned int i) { return leg.targets[i] && leg.targets[i]->value != 0; };
  return (is_nonzero(2) && leg.targets[2]->by_force && leg.targets[2]->value < 0) || is_nonzero(3) ||
         is_nonzero(4);
}

void warn_of_large_strain(const std::string &motion, const double largest, const std::string &strain,
                          const GeometryOptions &geometry, std::vector<std::string> &warnings)
{
  constexpr double small = 0.05; // strains that linear elasticity is good for
  constexpr double percent = 100;
  const double height = geometry.held_height();
  if (largest / height > small)
    warnings.push_back("Load program: " + motion + " up to " + to_text(largest) + " mm on " +
                       kind_of(geometry).height_entry(geometry) + " = " + to_text(height) + " mm " + strain +
                       " of " + to_text(std::round(percent * largest / height)) +
                       " %; the program computes with small strains, which is good up to about 5 %. A "
                       "smaller motion keeps within it");
}

/// The largest coefficient of friction; infinite where a law that is no ellipse depends on the place, or
/// friction has memory.
double largest_friction(const FrictionOptions &friction)
{
  if (friction.has_factor() && !friction.factor.is_constant())
    return std::numeric_limits<double>::infinity();
  if (friction.has_ellipses())
    return friction.factor.value({}) * std::max(friction.mu[0], friction.mu[1]);
  return friction.varies() ? std::numeric_limits<double>::infinity()
                           : friction.law.chosen().law(friction, {0, 0, 0}).largest_friction();
}

/// The largest motion (mm) by which friction can shear the body sideways under a compression by `compression`
/// (mm): mu E strain / G times the height.
double sheared_by_friction(const Parameters &parameters, const double compression)
{
  return 2 * (1 + parameters.material.isotropic().poisson_ratio) * largest_friction(parameters.friction) *
         compression;
}

void warn_of_large_strains(const Parameters &parameters, const std::vector<PathLeg> &path,
                           std::vector<std::string> &warnings)
{
  if (!kind_of(parameters.geometry).has_known_sizes())
    return;
  double compression = 0;
  double sideways = 0;
  for (const PathLeg &leg : path)
  {
    compression = std::max(compression, std::abs(leg.motion(2)));
    sideways = std::max(sideways, std::hypot(leg.motion(0), leg.motion(1)));
  }
  warn_of_large_strain("|u_z|", compression, "is a strain", parameters.geometry, warnings);
  // The base slides if it is moved any further.
  const double sheared = std::min(sideways, sheared_by_friction(parameters, compression));
  warn_of_large_strain("|u_t| without sliding", sheared, "is a shear", parameters.geometry, warnings);
}

void warn_of_no_contact(const std::vector<PathLeg> &path, std::vector<std::string> &warnings)
{
  const auto presses = [](const PathLeg &leg) { return leg.motion(2) < 0 || presses_otherwise(*leg.leg); };
  if (std::none_of(path.begin(), path.end(), presses))
    warnings.emplace_back(
        "Load program: no leg has u_z < 0, so that nothing presses the body on the counterface and there are "
        "no contact forces; Legs or Preload need a motion uz < 0 or a force Fz < 0");
}

void warn_of_idle_loads(const std::vector<PathLeg> &path, const std::vector<Load> &loads,
                        std::vector<std::string> &warnings)
{
  for (std::size_t k = 0; k < loads.size(); ++k)
    if (std::none_of(path.begin(), path.end(), [&](const PathLeg &leg) { return leg.loads_after[k] != 0; }))
      warnings.push_back(
          "Load program/Loads: no leg drives " + loads[k].name +
          " away from 0, so that it does nothing; name it in Legs or Preload, or leave it out");
}

void warn_of_large_rotations(const std::vector<PathLeg> &path, std::vector<std::string> &warnings)
{
  constexpr double most = 1;
  double largest = 0;
  for (const PathLeg &leg : path)
    largest = std::max({largest, std::abs(leg.motion(3)), std::abs(leg.motion(4)), std::abs(leg.motion(5))});
  if (largest > most)
    warnings.push_back(
        "Load program: rotations up to " + to_text(largest) +
        " degrees; the program computes with linearized rotations, which is good up to about 1 degree");
}

void warn_of_coarse_rim(const BodyOptions &body, std::vector<std::string> &warnings)
{
  if (std::string warning = coarse_rim_warning(body); !warning.empty())
    warnings.push_back(std::move(warning));
}

/// Whether the rim of the lower body touches the upper one, whose base is no smaller.
bool rim_of_lower_body_touches(const Parameters &parameters)
{
  const GeometryOptions &upper = parameters.geometry, &lower = parameters.lower.geometry;
  const ShapeKind &of_upper = kind_of(upper), &of_lower = kind_of(lower);
  return of_upper.has_known_sizes() && of_lower.has_known_sizes() && rim_surely_touches(parameters) &&
         of_lower.half_widths(lower)[1] <= of_upper.half_widths(upper)[0];
}
} // namespace

bool rim_surely_touches(const Parameters &parameters)
{
  return parameters.obstacle.is_plane();
}

std::vector<std::string> parameter_warnings(const Parameters &parameters)
{
  std::vector<std::string> warnings;
  const std::vector<PathLeg> path = load_path(parameters.load);
  warn_of_slip_ellipse(parameters.friction, warnings);
  warn_of_locking(parameters, warnings);
  warn_of_large_strains(parameters, path, warnings);
  warn_of_large_rotations(path, warnings);
  warn_of_idle_loads(path, parameters.load.loads, warnings);
  if (parameters.obstacle.is_plane() && kind_of(parameters.geometry).has_known_sizes())
    warn_of_no_contact(path, warnings);
  warn_of_periods(parameters.load, parameters.contact_solver.tolerance, warnings);
  if (rim_surely_touches(parameters))
    warn_of_coarse_rim(parameters, warnings);
  if (parameters.obstacle.kind == ObstacleKind::body)
  {
    warn_of_locking(parameters.lower, warnings);
    if (rim_of_lower_body_touches(parameters))
      warn_of_coarse_rim(parameters.lower, warnings);
  }
  warn_of_weak_method(parameters.contact_solver, warnings);
  for (std::string &warning : ignored_entries(DeclaredParameters(parameters).list, DeclaredParameters().list))
    warnings.push_back(std::move(warning));
  return warnings;
}
} // namespace orthocone
