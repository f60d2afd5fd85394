// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/contact_solver.h>
#include <orthocone/elasticity/condensed_body.h>
#include <orthocone/simulation/contact_state.h>
#include <orthocone/simulation/totals.h>

#include <optional>
#include <string>

namespace orthocone
{
/// What independent checks of a step say: all but work and energy relative, 0 is perfect.
struct StepChecks
{
  double equilibrium = 0; ///< of the body under the final forces, and of the contact displacements with it
  LawErrors law;          ///< of the contact law
  double work = 0;        ///< of the upper face in the step by the trapezoidal rule, N mm
  double energy = 0; ///< the largest so far, stored or work in a step with either of its end forces, N mm
  double energy_defect = 0; ///< work - change of elastic energy - dissipation, relative to `energy`
  bool is_finite = true;    ///< all numbers of the state are
};

/// Checks steps from their final states, by code that no solver owns. Holds no memory of earlier steps.
class StepChecker
{
public:
  /// All but `parameters` must outlive the checker.
  StepChecker(const Parameters &parameters, const CondensedBody &body, const Stiffness &stiffness);

  /// `top_before` and `before`: upper face and totals before the step; `largest_energy`: of the steps before.
  StepChecks check(const std::array<double, 3> &top_before, const Totals &before, const ContactState &after,
                   const Totals &totals, const LawErrors &law, double largest_energy) const;

  /// The sentence on the first check that exceeds its bound, naming its entry, or nothing.
  std::optional<std::string> violation(const StepChecks &checks) const;

private:
  double equilibrium(const ContactState &state) const;

  CheckOptions options_;
  double tolerance_;
  double length_; ///< largest motion of the upper face, mm
  const CondensedBody &body_;
  const Stiffness &stiffness_;
};
} // namespace orthocone
