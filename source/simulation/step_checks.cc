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

/// The natural map sees slip with the weights (p/mu)^2, the slip rule without.
double slip_amplification(const FrictionOptions &friction)
{
  const double x = friction.p[0] / friction.mu[0];
  const double y = friction.p[1] / friction.mu[1];
  return std::max(x / y, y / x) * std::max(x / y, y / x);
}

/// Dissipation of nodes in an undivided step that is negative, or more than the larger of the friction forces
/// before and after can do on the way of the slip.
double impossible_dissipation(const ContactState &before, const ContactState &after)
{
  double wrong = 0;
  for (Eigen::Index node = 0; node < after.n_nodes(); ++node)
  {
    const double done = after.dissipated_energy[node] - before.dissipated_energy[node];
    const double way = after.accumulated_slip[node] - before.accumulated_slip[node];
    const double friction =
        std::max(before.force.segment<2>(3 * node + 1).norm(), after.force.segment<2>(3 * node + 1).norm());
    wrong = std::max({wrong, -done, done - way * friction});
  }
  return wrong;
}

double ratio(const double value, const double scale)
{
  return value == 0 ? 0 : value / scale;
}
} // namespace

StepChecker::StepChecker(const Parameters &parameters, const SymmetryPlanes &planes,
                         const CondensedBody &body, const Stiffness &stiffness)
    : options_(parameters.checks),
      tolerance_(parameters.contact_solver.tolerance),
      slip_amplification_(slip_amplification(parameters.friction)),
      n_copies_(planes.n_copies()),
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

/// Work of the top - change of elastic energy = -(work of the mean contact forces), whatever the forces: an
/// error tells of totals, energies or displacements that do not belong to the forces.
double StepChecker::identity_error(const Situation &before, const Situation &after, const double work) const
{
  const double of_contact =
      -0.5 * n_copies_ *
      (before.state.force + after.state.force).dot(after.state.displacement - before.state.displacement);
  return std::abs(work - (after.totals.elastic_energy - before.totals.elastic_energy) - of_contact);
}

StepChecks StepChecker::check(const Situation &before, const Situation &after, const SolverReport &report,
                              const double largest_energy) const
{
  StepChecks checks;
  checks.is_finite = is_finite(after.state, after.totals);
  checks.law = report.law;
  checks.equilibrium = equilibrium(after.state);
  const double work_first = work_of(before.totals.force, before.state.top, after.state.top);
  const double work_last = work_of(after.totals.force, before.state.top, after.state.top);
  checks.work = 0.5 * (work_first + work_last);
  // Dissipation must not be in the scale: if it is wrong, it is large.
  checks.energy =
      std::max({largest_energy, after.totals.elastic_energy, std::abs(work_first), std::abs(work_last)});
  double identity = identity_error(before, after, checks.work);
  if (report.n_parts == 1)
    identity = std::max(identity, n_copies_ * impossible_dissipation(before.state, after.state));
  checks.energy_identity = ratio(identity, checks.energy);
  const double defect = checks.work - (after.totals.elastic_energy - before.totals.elastic_energy) -
                        (after.totals.total_dissipation - before.totals.total_dissipation);
  checks.energy_defect = ratio(std::abs(defect), checks.energy);
  return checks;
}

std::optional<std::string> StepChecker::violation(const StepChecks &checks) const
{
  if (!checks.is_finite)
    return "forces, displacements or energies are no longer numbers: are lengths in mm, forces in N, moduli "
           "in MPa?";
  constexpr double most_of_slip_rule = 1e-3;
  const double slip_rule = tolerance_ * options_.slip_rule;
  const std::array<std::tuple<const char *, double, double>, 7> all{{
      {"Equilibrium", checks.equilibrium, options_.equilibrium},
      {"Penetration", checks.law.penetration, tolerance_ * options_.penetration},
      {"Complementarity", checks.law.complementarity, tolerance_ * options_.complementarity},
      {"Friction cone", checks.law.friction_cone, tolerance_ * options_.friction_cone},
      {"Slip rule", checks.law.slip_rule,
       std::max(slip_rule, std::min(slip_amplification_ * slip_rule, most_of_slip_rule))},
      // Nodes that stick may creep as far as the tolerance lets them.
      {"Energy identity", checks.energy_identity, std::max(tolerance_, options_.energy_identity)},
      {"Energy defect", checks.energy_defect, options_.energy_defect},
  }};
  for (const auto &[name, value, bound] : all)
    if (!(value <= bound))
      return std::string("Checks/") + name + ": " + to_text(value) + " exceeds the bound " + to_text(bound) +
             (&value == &std::get<1>(all.back()) ? "; the leg needs more steps" : "");
  return std::nullopt;
}
} // namespace orthocone
