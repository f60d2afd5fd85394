// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/step_checks.h>

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>
#include <orthocone/body/node_compliance.h>
#include <orthocone/march/friction_memory.h>
#include <orthocone/march/implicit_wear.h>
#include <orthocone/scene/load_program.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace orthocone
{
namespace
{
/// Work (N mm) of force and moment of the held face, and of the loads, with the forces of `at` on the motions
/// from `before` to `after`. Where a load gives tractions or a force, its conjugate is the motion.
double work_of(const Situation &at, const Situation &before, const Situation &after,
               const std::vector<Load> &loads)
{
  const RigidMotion &first = before.state.motion, &last = after.state.motion;
  double work = at.totals.held.force().dot(last.translation() - first.translation()) +
                at.totals.held.moment().dot(last.rotation() - first.rotation());
  for (std::size_t i = 0; i < loads.size(); ++i)
  {
    const auto k = static_cast<Eigen::Index>(i);
    const bool gives_force = loads[i].kind->acts_by_traction() || loads[i].kind->is_force_of_surface();
    // Before the first step there are no totals, and no loads.
    const auto of = [k](const Eigen::VectorXd &all) { return all.size() > 0 ? all[k] : 0; };
    const double load = of(after.totals.loads) - of(before.totals.loads),
                 conjugate = of(after.totals.conjugates) - of(before.totals.conjugates);
    work += gives_force ? of(at.totals.loads) * conjugate : of(at.totals.conjugates) * load;
  }
  return work;
}

bool is_finite(const ContactState &state, const Totals &totals)
{
  return state.force.allFinite() && state.displacement.allFinite() && state.accumulated_slip.allFinite() &&
         state.dissipated_energy.allFinite() && state.wear_depth.allFinite() && totals.force.allFinite() &&
         totals.moment.allFinite() && std::isfinite(totals.elastic_energy) &&
         std::isfinite(totals.total_dissipation);
}

/// The reduced force of the reduced slip weights slip, by (p/mu)^2 for ellipses; the slip rule does not.
double slip_amplification(const ContactSystem &system)
{
  double largest = 1;
  for (Eigen::Index node = 0; node < system.n_nodes(); ++node)
    largest = std::max(largest, system.law(node).slip_amplification());
  return largest;
}

/// Largest slip of a node in contact relative to the length over which gap or friction change there.
double slip_of_change(const ContactState &state, const Eigen::VectorXd &lengths)
{
  double largest = 0;
  for (Eigen::Index node = 0; node < lengths.size(); ++node)
    if (state.status[node] != NodeStatus::open)
      largest = std::max(largest, state.displacement.segment<2>(3 * node + 1).norm() / lengths[node]);
  return largest;
}

/// Dissipation of nodes in an undivided step that is negative, or more than the larger of the friction forces
/// before and after can do on the way of the slip. A node that counts as open, but has a force, because a
/// long slide has lost the digits of its gap, dissipates nothing where it should.
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
    if (after.status[node] == NodeStatus::open)
      wrong = std::max(wrong, after.force.segment<2>(3 * node + 1).norm() *
                                  (after.displacement - before.displacement).segment<2>(3 * node + 1).norm());
  }
  return wrong;
}

/// Work of the mean normal forces on the room that wear has made before the step, N mm: it leaves the body
/// with the material.
double work_into_wear(const ContactState &before, const ContactState &after)
{
  double work = 0;
  for (Eigen::Index node = 0; node < after.n_nodes(); ++node)
    work += 0.5 * (before.force[3 * node] + after.force[3 * node]) *
            (after.found_depth[node] - before.found_depth[node]);
  return work;
}

/// Includes the lower body under the same forces, and the part of its displacements in the gap and slip.
void include(BodyMismatch &mismatch, const LowerBody &lower, MismatchMemory &memory, const NodeVector &force,
             const NodeVector &given_way, const double bound)
{
  const NodeVector own_force = lower.own_force(force);
  NodeVector own;
  lower.body().compliance().vmult(own, own_force);
  const BodyMismatch of_lower = memory.of(own_force, own, bound);
  mismatch.unbalanced = std::max(mismatch.unbalanced, of_lower.unbalanced);
  mismatch.displacement = std::max({mismatch.displacement, of_lower.displacement,
                                    (lower.parted(own) - given_way).lpNorm<Eigen::Infinity>()});
}
} // namespace

StepChecker::StepChecker(const Scene &scene, const CheckOptions &options, const double tolerance)
    : options_(options),
      tolerance_(tolerance),
      slip_amplification_(slip_amplification(scene.system())),
      n_copies_(scene.symmetry().n_copies()),
      compression_(scene.program().largest_motion(2)),
      reach_(reach_of(scene.body().unknowns())),
      length_(largest_way(scene.parameters().load, reach_)),
      gaps_(scene.gaps()),
      change_lengths_(scene.change_lengths()),
      opening_(node_compliance(scene.surface(), scene.symmetry(), scene.contact_material())),
      scene_(scene),
      body_(scene.body())
{
  if (const LowerBody *const lower = scene.lower())
    lower_.emplace(lower->body());
}

void StepChecker::check_equilibrium(const ContactState &state, StepChecks &checks)
{
  const NodeVector given_way = scene_.given_way(state.force);
  const NodeVector driven = scene_.driven_displacement(state.motion, state.loads);
  const NodeVector elastic = unworn_displacement(state) - gaps_ - driven - given_way;
  checks.motion = motion_checks(scene_, state, elastic, given_way);
  auto mismatch = body_.of(state.force, elastic, options_.equilibrium);
  if (lower_)
    include(mismatch, *scene_.lower(), *lower_, state.force, given_way, options_.equilibrium);
  checks.equilibrium =
      std::max(mismatch.unbalanced,
               relative(mismatch.displacement,
                        std::max({length_, state.motion.size(reach_), driven.lpNorm<Eigen::Infinity>(),
                                  elastic.lpNorm<Eigen::Infinity>()})));
  checks.volume = std::move(mismatch.volume);
}

/// Work of the top - change of elastic energy = -(work of the mean contact forces), whatever the forces: an
/// error shows totals, energies or displacements that do not belong to the forces.
double StepChecker::identity_error(const Situation &before, const Situation &after, const double work) const
{
  const double of_contact = -0.5 * n_copies_ *
                            (before.state.force + after.state.force)
                                .dot(unworn_displacement(after.state) - unworn_displacement(before.state));
  return std::abs(work - (after.totals.elastic_energy - before.totals.elastic_energy) - of_contact);
}

StepChecks StepChecker::check(const Situation &before, const Situation &after, const SolverReport &report,
                              const double largest_energy)
{
  StepChecks checks;
  checks.is_finite = is_finite(after.state, after.totals);
  checks.law = report.law;
  checks.wear_of_flattening = unfound_wear(before.state, after.state, opening_);
  checks.change_of_factor = change_of_factor(before.state, after.state);
  checks.energy_of_fall = n_copies_ * energy_of_fall(before.state, after.state);
  checks.slip_of_change = slip_of_change(after.state, change_lengths_);
  // The law's own measure is relative to all displacements, which are large in a long slide.
  if (compression_ > 0)
    checks.law.penetration = std::max(checks.law.penetration, report.penetration / compression_);
  check_equilibrium(after.state, checks);
  const std::vector<Load> &loads = scene_.parameters().load.loads;
  const double work_first = work_of(before, before, after, loads);
  const double work_last = work_of(after, before, after, loads);
  const double in_one = 0.5 * (work_first + work_last);
  checks.work = report.n_parts > 1
                    ? after.state.work - before.state.work
                    : in_one + n_copies_ * work_without_contact(before.state, after.state, opening_);
  // Dissipation must not be in the scale, because it is large if it is wrong.
  checks.energy =
      std::max({largest_energy, after.totals.elastic_energy, std::abs(work_first), std::abs(work_last)});
  double identity = identity_error(before, after, in_one);
  if (report.n_parts == 1)
    identity = std::max(identity, n_copies_ * impossible_dissipation(before.state, after.state));
  checks.energy_identity = relative(identity, checks.energy);
  checks.into_wear = n_copies_ * work_into_wear(before.state, after.state);
  const double defect = checks.work - (after.totals.elastic_energy - before.totals.elastic_energy) -
                        (after.totals.total_dissipation - before.totals.total_dissipation) - checks.into_wear;
  checks.energy_defect = relative(std::abs(defect), checks.energy);
  return checks;
}

std::optional<std::string> StepChecker::violation(const StepChecks &checks) const
{
  if (!checks.is_finite)
    return "forces, displacements or energies are no longer numbers: are lengths in mm, forces in N, moduli "
           "in MPa?";
  if (auto impossible = orthocone::violation(checks.motion))
    return impossible;
  struct Check
  {
    const char *name;
    double value;
    double bound;
    const char *remedy = "";
  };
  const std::array<Check, 7> all{{
      {"Equilibrium", checks.equilibrium, options_.equilibrium,
       "; where the Poisson ratio is next to 0.5, or moduli differ a millionfold, rounding leaves no more "
       "digits, so that a larger bound is needed"},
      {"Penetration", checks.law.penetration, law_bound(options_.penetration),
       "; where a slide is far longer than the body is pressed, rounding leaves no more digits, so that a "
       "larger bound is needed"},
      {"Complementarity", checks.law.complementarity, law_bound(options_.complementarity)},
      {"Friction cone", checks.law.friction_cone, law_bound(options_.friction_cone)},
      {"Slip rule", checks.law.slip_rule, slip_rule_bound()},
      // Nodes that stick may creep as far as the tolerance lets them.
      {"Energy identity", checks.energy_identity, std::max(tolerance_, options_.energy_identity)},
      {"Energy defect", checks.energy_defect, options_.energy_defect,
       "; take more steps in this leg (Load program/Legs)"},
  }};
  for (const Check &check : all)
    if (!(check.value <= check.bound))
      return std::string("Checks/") + check.name + ": " + to_text(check.value) + " exceeds the bound " +
             to_text(check.bound) + check.remedy;
  return std::nullopt;
}

/// Whatever the tolerance, the law is violated where a tenth of the largest force or displacement is wrong.
double StepChecker::law_bound(const double multiple) const
{
  constexpr double most = 0.1;
  return std::min(tolerance_ * multiple, most);
}

double StepChecker::slip_rule_bound() const
{
  constexpr double most_by_amplification = 1e-3; // docs/theory.md, section 5
  const double bound = law_bound(options_.slip_rule);
  return std::max(bound, std::min(slip_amplification_ * bound, most_by_amplification));
}
} // namespace orthocone
