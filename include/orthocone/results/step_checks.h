// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/march/contact_state.h>
#include <orthocone/results/totals.h>
#include <orthocone/scene/scene.h>

#include <optional>
#include <string>

namespace orthocone
{
/// What independent checks of a step say: all but work and energy relative, 0 is perfect.
struct StepChecks
{
  double equilibrium = 0; ///< of the body under the final forces, and of the contact displacements with it
  LawErrors law;          ///< of the contact law
  double work = 0;        ///< of the held face by the trapezoidal rule over what was solved in the step, N mm
  double energy = 0; ///< the largest so far, stored or work in a step with either of its end forces, N mm
  double energy_identity = 0; ///< error of what holds for any forces, and dissipation that no force can do
  double energy_defect = 0;   ///< work - change of elastic energy - dissipation, relative to `energy`
  double slip_of_change =
      0; ///< largest slip in contact relative to the length over which gap and friction change
  double wear_of_flattening = 0; ///< largest depth worn in the step relative to what the normal force of the
                                 ///< node flattens the body by
  bool is_finite = true;         ///< all numbers of the state are
  Eigen::VectorXd volume{};      ///< K^-1 r of the free unknowns, from which equilibrium is judged, mm
};

/// A state and the totals of the whole body in it.
struct Situation
{
  const ContactState &state;
  const Totals &totals;
};

/// Checks steps from the states at their ends, by code that no solver owns. Holds no memory of earlier steps.
class StepChecker
{
public:
  /// `tolerance`: of the contact solver. `scene` must outlive the checker.
  StepChecker(const Scene &scene, const CheckOptions &options, double tolerance);

  /// `largest_energy`: StepChecks::energy of the steps before.
  StepChecks check(const Situation &before, const Situation &after, const SolverReport &report,
                   double largest_energy) const;

  /// The sentence on the first check that exceeds its bound, naming its entry, or nothing.
  std::optional<std::string> violation(const StepChecks &checks) const;

private:
  double law_bound(double multiple) const;
  double slip_rule_bound() const;
  void check_equilibrium(const ContactState &state, StepChecks &checks) const;
  double identity_error(const Situation &before, const Situation &after, double work) const;

  CheckOptions options_;
  double tolerance_;
  double slip_amplification_; ///< of errors of the natural map in the slip rule
  unsigned int n_copies_;
  double compression_; ///< largest motion of the upper face along z, mm
  double reach_;       ///< reach_of(), mm
  double length_;      ///< largest_way() of what motions drive, mm
  const NodeVector &gaps_;
  const Eigen::VectorXd &change_lengths_;
  const Eigen::VectorXd opening_; ///< node_compliance()
  const ElasticBody &body_;
  const Scene &scene_;
};
} // namespace orthocone
