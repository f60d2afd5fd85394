// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/march/contact_state.h>
#include <orthocone/results/mismatch_memory.h>
#include <orthocone/results/motion_checks.h>
#include <orthocone/results/totals.h>
#include <orthocone/scene/scene.h>

#include <optional>
#include <string>

namespace orthocone
{
/// Results of independent checks of a step (docs/theory.md, section 5). All but work and energy are relative;
/// 0 is perfect.
struct StepChecks
{
  double equilibrium = 0; ///< of the body under the final forces, and with the contact displacements
  LawErrors law;          ///< of the contact law
  double work = 0; ///< of the held face over the solved parts of the step (docs/theory.md, section 4), N mm
  double into_wear = 0;       ///< the part of it that leaves the body with worn material, N mm
  double energy = 0;          ///< largest so far: stored, or work in a step with a force at either end, N mm
  double energy_identity = 0; ///< error of an identity of all forces, and impossible dissipation
  double energy_defect =
      0; ///< work - change of elastic energy - dissipation - into_wear, relative to `energy`
  double slip_of_change =
      0; ///< largest slip in contact relative to the length over which gap and friction change
  double wear_of_flattening = 0; ///< largest depth worn in the step relative to what the normal force of the
                                 ///< node flattens the body by
  double change_of_factor =
      0;                     ///< largest relative change of a node's factor of friction from the step before
  double energy_of_fall = 0; ///< that the fall of friction in slip sets free, N mm
  MotionChecks motion{};
  bool is_finite = true;    ///< all numbers of the state are
  Eigen::VectorXd volume{}; ///< K^-1 r of the free unknowns, by which equilibrium is judged, mm
};

/// A state and the totals of the whole body in it.
struct Situation
{
  const ContactState &state;
  const Totals &totals;
};

/// Checks steps by the states at their ends, with code that no solver uses. Of earlier steps it knows only
/// how the bodies have answered the same forces, so that its verdicts do not depend on them.
class StepChecker
{
public:
  /// `tolerance` is the contact solver's. `scene` must outlive the checker.
  StepChecker(const Scene &scene, const CheckOptions &options, double tolerance);

  /// Checks the step between two situations. `largest_energy` is StepChecks::energy of the steps before (N
  /// mm). Throws SolveError where the body cannot be solved.
  StepChecks check(const Situation &before, const Situation &after, const SolverReport &report,
                   double largest_energy);

  /// The sentence on the first check that exceeds its bound, which names its entry, or nothing.
  std::optional<std::string> violation(const StepChecks &checks) const;

private:
  double law_bound(double multiple) const;
  double slip_rule_bound() const;
  void check_equilibrium(const ContactState &state, StepChecks &checks);
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
  const Scene &scene_;
  MismatchMemory body_;
  std::optional<MismatchMemory> lower_{};
};
} // namespace orthocone
