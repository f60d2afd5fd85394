// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/backend_choice.h>

#include <orthocone/accuracy/estimate.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/text.h>
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
  if (parameters.obstacle.kind.chosen().gives_way())
    return "Obstacle/Kind = " + to_word(parameters.obstacle.kind);
  if (parameters.output.problem_interval != 0)
    return "Output/Problems = " + std::to_string(parameters.output.problem_interval);
  if (!parameters.material.is_uniform_and_isotropic())
    return parameters.material.is_orthotropic() ? "Material/Law = orthotropic" : "Material/Regions";
  if (find_contact_method(parameters.contact_solver.method)->needs_dense)
    return "Contact solver/Method = " + parameters.contact_solver.method;
  return "";
}

/// The same, or the entry with which it may not reach equilibrium.
std::string what_multigrid_is_not_for(const Parameters &parameters)
{
  constexpr double nearly_incompressible = 0.495; // docs/stability.md, "On the whole body"
  const double nu = parameters.material.poisson_ratio;
  const std::string entry = what_multigrid_cannot(parameters);
  const bool locks = nu >= nearly_incompressible &&
                     parameters.mesh.resolved_volumetric_quadrature() == VolumetricQuadrature::full;
  return entry.empty() && locks
             ? "Material/Poisson ratio = " + to_text(nu) + " with full volumetric quadrature"
             : entry;
}

std::string described(const Estimate &cost, const double seconds)
{
  std::ostringstream text;
  text << std::setprecision(2) << seconds << " s and " << cost.gigabytes << " GB";
  return text.str();
}

/// Several processes share a body with multigrid only, but a factorization by one of them may take less time.
std::string if_one_is_faster(const Parameters &parameters, const ModelSymmetry &symmetry,
                             const double gigabytes)
{
  const ModelSize size = model_size(parameters, symmetry);
  const Estimate one = usual_estimate(parameters, size, symmetry);
  const Estimate all = multigrid_estimate(parameters, size, symmetry);
  const double n_steps = LoadProgram(parameters.load).n_solved_parts();
  const double of_one = one.set_up_seconds + n_steps * one.step_seconds;
  // Each process sets up the coarsest mesh on its own.
  const double of_all = all.set_up_seconds + n_steps * all.step_seconds / n_ranks();
  if (one.gigabytes > gigabytes || of_one >= of_all)
    return "";
  return "; one process alone would take less time, condensed about " + described(one, of_one);
}
} // namespace

bool multigrid_can(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  return !symmetry.is_axisymmetric() && what_multigrid_cannot(parameters).empty();
}

BackendChoice choose_backend(const Parameters &parameters, const ModelSymmetry &symmetry,
                             const double gigabytes)
{
  constexpr double not_worth_comparing = 20; // s, where no cell is halved
  if (parameters.mesh.backend != BodyBackend::automatic || (symmetry.is_axisymmetric() && n_ranks() == 1))
    return {parameters.mesh.backend};
  const std::string line = "backend        ";
  if (n_ranks() > 1)
    return {BodyBackend::multigrid, line + "multigrid: " + std::to_string(n_ranks()) + " processes" +
                                        if_one_is_faster(parameters, symmetry, gigabytes)};
  const ModelSize size = model_size(parameters, symmetry);
  const Estimate condensed = usual_estimate(parameters, size, symmetry);
  // Where cycles may be jumped, most of them are, as a rule.
  const double n_steps = least_computed_parts(parameters.load, parameters.wear);
  const double seconds_condensed = condensed.set_up_seconds + n_steps * condensed.step_seconds;
  const bool fits = condensed.gigabytes <= gigabytes;
  const bool is_halved = parameters.mesh.refinements > 0 || !parameters.mesh.refined_cells.empty();
  if (!is_halved && (fits ? seconds_condensed < not_worth_comparing
                          : multigrid_gigabytes(parameters, size, symmetry) > gigabytes))
    return {parameters.mesh.backend};
  const std::string of_condensed = "condensed about " + described(condensed, seconds_condensed);
  if (const std::string entry = what_multigrid_is_not_for(parameters); !entry.empty())
    return {parameters.mesh.backend, line + of_condensed + "; multigrid is not for " + entry};
  const Estimate multigrid = multigrid_estimate(parameters, size, symmetry);
  const double seconds_multigrid = multigrid.set_up_seconds + n_steps * multigrid.step_seconds;
  const std::string of_multigrid = "multigrid about " + described(multigrid, seconds_multigrid);
  // Without coarser meshes contact has no good start, so that multigrid must be clearly faster.
  const double margin = is_halved ? 1 : 2;
  if (fits && seconds_condensed <= margin * seconds_multigrid)
    return {BodyBackend::condensed, line + of_condensed + "; " + of_multigrid};
  return {BodyBackend::multigrid, line + of_multigrid + "; " + of_condensed};
}
} // namespace orthocone
