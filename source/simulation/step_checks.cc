// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/step_checks.h>

#include <orthocone/parameters/text.h>
#include <orthocone/simulation/load_program.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
/// Work that a force of the upper face, which balances that of the plane, does on the way of a step.
double work_of(const Eigen::Vector3d &force_of_plane, const std::array<double, 3> &before,
               const std::array<double, 3> &after)
{
  double work = 0;
  for (unsigned int d = 0; d < 3; ++d)
    work -= force_of_plane[d] * (after[d] - before[d]);
  return work;
}

bool is_finite(const ContactState &state, const Totals &totals)
{
  return state.force.allFinite() && state.displacement.allFinite() && state.accumulated_slip.allFinite() &&
         state.dissipated_energy.allFinite() && totals.force.allFinite() &&
         std::isfinite(totals.elastic_energy) && std::isfinite(totals.total_dissipation);
}

double ratio(const double value, const double scale)
{
  return value == 0 ? 0 : value / scale;
}
} // namespace

StepChecker::StepChecker(const Parameters &parameters, const CondensedBody &body, const Stiffness &stiffness)
    : options_(parameters.checks),
      tolerance_(parameters.contact_solver.tolerance),
      length_(std::max({largest_motion(parameters.load, 0), largest_motion(parameters.load, 1),
                        largest_motion(parameters.load, 2)})),
      body_(body),
      stiffness_(stiffness)
{
}

double StepChecker::equilibrium(const ContactState &state) const
{
  const NodeVector elastic = state.displacement - body_.free_displacement(state.top);
  const auto mismatch = body_.mismatch(stiffness_, state.force, elastic);
  return std::max(mismatch.unbalanced, ratio(mismatch.displacement, length_));
}

StepChecks StepChecker::check(const std::array<double, 3> &top_before, const Totals &before,
                              const ContactState &after, const Totals &totals, const LawErrors &law,
                              const double largest_energy) const
{
  StepChecks checks;
  checks.is_finite = is_finite(after, totals);
  checks.law = law;
  checks.equilibrium = equilibrium(after);
  const double work_first = work_of(before.force, top_before, after.top);
  const double work_last = work_of(totals.force, top_before, after.top);
  checks.work = 0.5 * (work_first + work_last);
  // Dissipation must not be in the scale: if it is wrong, it is large.
  checks.energy =
      std::max({largest_energy, totals.elastic_energy, std::abs(work_first), std::abs(work_last)});
  const double defect = checks.work - (totals.elastic_energy - before.elastic_energy) -
                        (totals.total_dissipation - before.total_dissipation);
  checks.energy_defect = ratio(std::abs(defect), checks.energy);
  return checks;
}

std::optional<std::string> StepChecker::violation(const StepChecks &checks) const
{
  if (!checks.is_finite)
    return "forces, displacements or energies are no longer numbers: are lengths in mm, forces in N, moduli "
           "in MPa?";
  const std::array<std::tuple<const char *, double, double>, 6> all{{
      {"Equilibrium", checks.equilibrium, options_.equilibrium},
      {"Penetration", checks.law.penetration, tolerance_ * options_.penetration},
      {"Complementarity", checks.law.complementarity, tolerance_ * options_.complementarity},
      {"Friction cone", checks.law.friction_cone, tolerance_ * options_.friction_cone},
      {"Slip rule", checks.law.slip_rule, tolerance_ * options_.slip_rule},
      {"Energy defect", checks.energy_defect, options_.energy_defect},
  }};
  for (const auto &[name, value, bound] : all)
    if (!(value <= bound))
      return std::string("Checks/") + name + ": " + to_text(value) + " exceeds the bound " + to_text(bound) +
             (&value == &std::get<1>(all.back()) ? "; the leg needs more steps" : "");
  return std::nullopt;
}
} // namespace orthocone
