// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "shape_checks.h"
#include "solver_entries.h"

#include <orthocone/base/text.h>
#include <orthocone/contact/solvers/contact_method.h>
#include <orthocone/parameters/lower_body.h>
#include <orthocone/parameters/parameters.h>
#include <orthocone/parameters/values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace orthocone
{
namespace
{
void warn_of_slip_ellipse(const FrictionOptions &friction, std::vector<std::string> &warnings)
{
  constexpr double most = 20;
  const double ratio = friction.p()[0] / friction.p()[1];
  if (std::max(ratio, 1 / ratio) > most)
    warnings.push_back(
        "Friction/Slip potential = " + to_text(friction.p()[0]) + ", " + to_text(friction.p()[1]) +
        ": axes differ more than 20-fold; nodes slip along one axis only, whatever the force, and "
        "the contact solver may need many iterations");
}

/// The largest Poisson's ratio of a material, and the entry that it stands in.
std::pair<std::string, double> most_incompressible(const MaterialOptions &material)
{
  const double ratio = material.isotropic().poisson_ratio;
  constexpr double shown_digits = 1e4; // of the average, which has rounding in its last ones
  std::pair most(material.is_orthotropic() ? "Material/Poisson ratios, on average " +
                                                 to_text(std::round(shown_digits * ratio) / shown_digits)
                                           : "Material/Poisson ratio = " + to_text(ratio),
                 ratio);
  for (const MaterialRegion &region : material.regions)
    if (region.poisson_ratio > most.second)
      most = {"Material/Regions: a Poisson ratio of " + to_text(region.poisson_ratio), region.poisson_ratio};
  return most;
}

void warn_of_coarse_rim(const Parameters &parameters, std::vector<std::string> &warnings)
{
  if (std::string warning = coarse_rim_warning(parameters); !warning.empty())
    warnings.push_back(std::move(warning));
}

void warn_of_locking(const MaterialOptions &material, const MeshOptions &mesh,
                     std::vector<std::string> &warnings)
{
  constexpr double nearly_incompressible = 0.48; // docs/stability.md, "Nearly incompressible bodies"
  if (mesh.resolved_volumetric_quadrature() == VolumetricQuadrature::projected)
    return;
  const auto [entry, ratio] = most_incompressible(material);
  if (ratio > nearly_incompressible)
    warnings.push_back(
        entry + " with Mesh/Degree = " + std::to_string(mesh.degree) +
        " and full volumetric quadrature: the elements lock, pressures and forces come out too "
        "large; take Mesh/Volumetric quadrature = projected");
}

/// Motion of the held face (mm, degrees) at the corners of the load program; 0 where it is unknown because a
/// force is given.
using Corner = std::array<double, n_rigid_components>;

std::vector<Corner> corners(const LoadOptions &load)
{
  std::vector<Corner> all;
  Corner corner{};
  const auto pass = [&](const std::vector<Leg> &legs)
  {
    for (const Leg &leg : legs)
    {
      for (unsigned int i = 0; i < n_rigid_components; ++i)
        corner[i] = leg.targets[i] ? leg.motion(i).value_or(0) : corner[i];
      all.push_back(corner);
    }
  };
  pass(load.preload);
  // The second cycle begins where the last leg of the first one ends; the others are like it.
  for (unsigned int cycle = 0; cycle < std::min(load.cycles, 2u); ++cycle)
    pass(load.legs);
  return all;
}

/// Whether a force or a tilt of the held face may press it down where u_z does not.
bool presses_otherwise(const Leg &leg)
{
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
                       height_entry(geometry) + " = " + to_text(height) + " mm " + strain + " of " +
                       to_text(std::round(percent * largest / height)) +
                       " %; the program computes with small strains, good to about 5 %");
}

/// The largest motion (mm) by which friction can shear the body sideways under a compression by `compression`
/// (mm): mu E strain / G times the height.
double sheared_by_friction(const Parameters &parameters, const double compression)
{
  return 2 * (1 + parameters.material.isotropic().poisson_ratio) *
         std::max(parameters.friction.mu[0], parameters.friction.mu[1]) * compression;
}

void warn_of_large_strains(const Parameters &parameters, std::vector<std::string> &warnings)
{
  if (parameters.geometry.is_from_file())
    return; // its height is not known here
  double compression = 0;
  double sideways = 0;
  for (const auto &corner : corners(parameters.load))
  {
    compression = std::max(compression, std::abs(corner[2]));
    sideways = std::max(sideways, std::hypot(corner[0], corner[1]));
  }
  warn_of_large_strain("|u_z|", compression, "is a strain", parameters.geometry, warnings);
  // The base slides if it is moved any further.
  const double sheared = std::min(sideways, sheared_by_friction(parameters, compression));
  warn_of_large_strain("|u_t| without sliding", sheared, "is a shear", parameters.geometry, warnings);
}

void warn_of_no_contact(const LoadOptions &load, std::vector<std::string> &warnings)
{
  const auto all = corners(load);
  const bool otherwise =
      std::any_of(load.preload.begin(), load.preload.end(), presses_otherwise) ||
      (load.cycles > 0 && std::any_of(load.legs.begin(), load.legs.end(), presses_otherwise));
  if (!otherwise && std::all_of(all.begin(), all.end(), [](const Corner &corner) { return corner[2] >= 0; }))
    warnings.emplace_back(
        "Load program: no leg has u_z < 0; the body is never pressed onto the plane and there "
        "are no contact forces");
}

void warn_of_large_rotations(const LoadOptions &load, std::vector<std::string> &warnings)
{
  constexpr double most = 1;
  double largest = 0;
  for (const Corner &corner : corners(load))
    largest = std::max({largest, std::abs(corner[3]), std::abs(corner[4]), std::abs(corner[5])});
  if (largest > most)
    warnings.push_back("Load program: rotations up to " + to_text(largest) +
                       " degrees; the program computes with linearized rotations, good to about 1 degree");
}

void warn_of_ignored_relaxation(const ContactSolverOptions &solver, std::vector<std::string> &warnings)
{
  if (!find_contact_method(solver.method)->has_relaxation &&
      solver.relaxation != ContactSolverOptions().relaxation)
    warnings.push_back("Contact solver/Relaxation = " + to_text(solver.relaxation) +
                       " is ignored with Contact solver/Method = " + solver.method + "; it is for " +
                       entries::contact_method_words(", ", [](const ContactMethod &method)
                                                     { return method.has_relaxation; }));
}

void warn_of_ignored_rho(const ContactSolverOptions &solver, std::vector<std::string> &warnings)
{
  if (find_contact_method(solver.method)->rho.empty() &&
      solver.rho_factor != ContactSolverOptions().rho_factor)
    warnings.push_back("Contact solver/Rho factor = " + to_text(solver.rho_factor) +
                       " is ignored with Contact solver/Method = " + solver.method +
                       ", which has no rho to be chosen");
}

void warn_of_weak_method(const ContactSolverOptions &solver, std::vector<std::string> &warnings)
{
  if (find_contact_method(solver.method)->is_for_study)
    warnings.push_back("Contact solver/Method = " + solver.method +
                       " is there to show where it fails (docs/stability.md); " +
                       ContactSolverOptions().method + " is the method to work with");
}

/// Warns of entries of a half-space that are set where there is none.
void warn_of_ignored_half_space(const ObstacleOptions &obstacle, std::vector<std::string> &warnings)
{
  if (obstacle.kind == ObstacleKind::half_space)
    return;
  const MaterialOptions &given = obstacle.material, usual;
  const std::string ignored = " is ignored with Obstacle/Kind = " + to_word(obstacle.kind);
  if (given.young_modulus != usual.young_modulus)
    warnings.push_back("Obstacle/Young modulus = " + to_text(given.young_modulus) + ignored);
  if (given.poisson_ratio != usual.poisson_ratio)
    warnings.push_back("Obstacle/Poisson ratio = " + to_text(given.poisson_ratio) + ignored);
}

/// Does the same for a lower body. Where there is one, warns of what is suspicious about it.
void warn_of_lower_body(const Parameters &parameters, std::vector<std::string> &warnings)
{
  if (parameters.obstacle.kind == ObstacleKind::body)
  {
    std::vector<std::string> of_lower;
    const Parameters lower = lower_parameters(parameters);
    warn_of_locking(lower.material, lower.mesh, of_lower);
    if (rim_of_lower_body_touches(parameters))
      warn_of_coarse_rim(lower, of_lower);
    warn_of_shape(lower, of_lower);
    for (const std::string &warning : of_lower)
      warnings.push_back(with_lower_sections(warning));
    return;
  }
  const auto values = entry_values(parameters), usual = entry_values(Parameters());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i].first.rfind("Lower ", 0) == 0 && values[i].second != usual[i].second)
      warnings.push_back(values[i].first + " = " + values[i].second +
                         " is ignored with Obstacle/Kind = " + to_word(parameters.obstacle.kind));
}

/// Forces may differ by a hundred times the residual that the solver leaves: W is that ill-conditioned.
void warn_of_unresolved_period(const std::string &entry, const double bound, const double tolerance,
                               std::vector<std::string> &warnings)
{
  constexpr double resolved = 100;
  if (bound > 0 && bound < resolved * tolerance)
    warnings.push_back("Load program/" + entry + " = " + to_text(bound) +
                       " is less than a hundred times Contact solver/Tolerance = " + to_text(tolerance) +
                       ": what the solver leaves may hide, or look like, a change from cycle to cycle");
}

/// Cycles that differ count as alike, so that what is jumped or left out has errors of about this size.
void warn_of_loose_period(const std::string &entry, const double bound, std::vector<std::string> &warnings)
{
  constexpr double most = 1e-3, percent = 100;
  if (bound > most)
    warnings.push_back("Load program/" + entry + " = " + to_text(bound) +
                       ": cycles count as alike whose forces differ by " + to_text(percent * bound) +
                       " % of the largest; slip and dissipation of the later ones may be as wrong, "
                       "1e-3 and less keeps them");
}
void warn_of_ignored_wear(const WearOptions &wear, std::vector<std::string> &warnings)
{
  if (wear.law != WearKind::none)
    return;
  for (const auto &[entry, value] :
       {std::pair("Coefficient", wear.coefficient), std::pair("Largest depth of a jump", wear.largest_jump)})
    if (value != 0)
      warnings.push_back(std::string("Wear/") + entry + " = " + to_text(value) +
                         " is ignored with Wear/Law = none");
}
} // namespace

std::vector<std::string> parameter_warnings(const Parameters &parameters)
{
  std::vector<std::string> warnings;
  warn_of_slip_ellipse(parameters.friction, warnings);
  warn_of_locking(parameters.material, parameters.mesh, warnings);
  warn_of_large_strains(parameters, warnings);
  warn_of_large_rotations(parameters.load, warnings);
  if (parameters.obstacle.is_plane() && !parameters.geometry.is_from_file())
    warn_of_no_contact(parameters.load, warnings);
  warn_of_unresolved_period("Stop when periodic", parameters.load.stop_when_periodic,
                            parameters.contact_solver.tolerance, warnings);
  warn_of_unresolved_period("Jump when periodic", parameters.load.jump_when_periodic,
                            parameters.contact_solver.tolerance, warnings);
  warn_of_loose_period("Stop when periodic", parameters.load.stop_when_periodic, warnings);
  warn_of_loose_period("Jump when periodic", parameters.load.jump_when_periodic, warnings);
  if (rim_surely_touches(parameters))
    warn_of_coarse_rim(parameters, warnings);
  warn_of_shape(parameters, warnings);
  warn_of_ignored_half_space(parameters.obstacle, warnings);
  warn_of_lower_body(parameters, warnings);
  warn_of_ignored_relaxation(parameters.contact_solver, warnings);
  warn_of_ignored_rho(parameters.contact_solver, warnings);
  warn_of_weak_method(parameters.contact_solver, warnings);
  warn_of_ignored_wear(parameters.wear, warnings);
  return warnings;
}
} // namespace orthocone
