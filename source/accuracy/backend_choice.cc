// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/backend_choice.h>

#include "cost_constants.h"

#include <orthocone/accuracy/cost_model.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/text.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/contact/solvers/contact_method.h>
#include <orthocone/scene/computed_steps.h>
#include <orthocone/scene/options.h>

#include <iomanip>
#include <sstream>
#include <string>

namespace orthocone
{
namespace
{
/// The entry with which multigrid cannot compute a solid; empty where it can.
std::string what_multigrid_cannot(const Parameters &parameters)
{
  if (const auto &kind = parameters.obstacle.kind;
      kind.chosen().gives_way() && kind != ObstacleKind::half_space)
    return "Obstacle/Kind = " + to_word(parameters.obstacle.kind);
  if (parameters.output.problem_interval != 0)
    return "Output/Problems = " + std::to_string(parameters.output.problem_interval);
  if (!parameters.material.is_uniform_and_isotropic())
    return parameters.material.is_isotropic() ? "Material/Regions" : parameters.material.law_entry();
  if (find_contact_method(parameters.contact_solver.method)->needs_dense)
    return "Contact solver/Method = " + parameters.contact_solver.method;
  if (!parameters.obstacle.has_normal_z()) // only where all normals are within 70 degrees of z
    return parameters.obstacle.distance.empty() ? "Obstacle/Normal = surface" : "Obstacle/Distance";
  return "";
}

/// The same, or the entry with which it may not reach equilibrium.
std::string what_multigrid_is_not_for(const Parameters &parameters)
{
  const double nu = parameters.material.poisson_ratio;
  const std::string entry = what_multigrid_cannot(parameters);
  const bool locks = nu >= cost::nearly_incompressible &&
                     parameters.mesh.resolved_volumetric_quadrature() == VolumetricQuadrature::full;
  return entry.empty() && locks
             ? "Material/Poisson ratio = " + to_text(nu) + " with full volumetric quadrature"
             : entry;
}

std::string described(const Estimate &estimate, const double seconds)
{
  std::ostringstream text;
  text << std::setprecision(2) << seconds << " s and " << estimate.gigabytes << " GB";
  return text.str();
}

/// Several processes share a body with multigrid only, but a factorization by one of them may take less time.
std::string if_one_is_faster(const Parameters &parameters, const ModelSymmetry &symmetry,
                             const double gigabytes)
{
  const CostModel model(parameters, symmetry);
  const Estimate one = model.usual(), all = model.multigrid();
  const double n_steps = LoadProgram(parameters.load).n_solved_parts();
  const double of_one = one.seconds(n_steps);
  // Each process sets up the coarsest mesh on its own.
  const double of_all = all.set_up_seconds + n_steps * all.step_seconds / n_ranks();
  if (one.gigabytes > gigabytes || of_one >= of_all)
    return "";
  return "; one process alone would take less time, condensed about " + described(one, of_one);
}
} // namespace

bool multigrid_can(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  return !symmetry.is_section() && what_multigrid_cannot(parameters).empty();
}

BackendChoice choose_backend(const Parameters &parameters, const ModelSymmetry &symmetry,
                             const double gigabytes)
{
  if (parameters.mesh.backend != BodyBackend::automatic || (symmetry.is_section() && n_ranks() == 1) ||
      !kind_of(parameters.geometry).is_meshed())
    return {parameters.mesh.backend};
  const std::string line = "backend        ";
  if (n_ranks() > 1)
    return {BodyBackend::multigrid, line + "multigrid: " + std::to_string(n_ranks()) + " processes" +
                                        if_one_is_faster(parameters, symmetry, gigabytes)};
  const CostModel model(parameters, symmetry);
  const Estimate condensed = model.usual();
  // Where cycles may be jumped, most of them are, as a rule.
  const double n_steps = least_computed_parts(parameters.load, parameters.wear);
  const double seconds_condensed = condensed.seconds(n_steps);
  const bool fits = condensed.gigabytes <= gigabytes;
  const bool is_halved = parameters.mesh.refinements > 0 || !parameters.mesh.refined_cells.empty();
  if (!is_halved &&
      (fits ? seconds_condensed < cost::not_worth_comparing : model.multigrid_gigabytes() > gigabytes))
    return {parameters.mesh.backend};
  const std::string of_condensed = "condensed about " + described(condensed, seconds_condensed);
  if (const std::string entry = what_multigrid_is_not_for(parameters); !entry.empty())
    return {parameters.mesh.backend, line + of_condensed + "; multigrid is not for " + entry};
  const Estimate multigrid = model.multigrid();
  const double seconds_multigrid = multigrid.seconds(n_steps);
  const std::string of_multigrid = "multigrid about " + described(multigrid, seconds_multigrid);
  const double margin = is_halved ? 1 : cost::margin_of_one_mesh;
  if (fits && seconds_condensed <= margin * seconds_multigrid)
    return {BodyBackend::condensed, line + of_condensed + "; " + of_multigrid};
  return {BodyBackend::multigrid, line + of_multigrid + "; " + of_condensed};
}
} // namespace orthocone
