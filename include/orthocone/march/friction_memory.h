// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/contact_state.h>
#include <orthocone/scene/scene.h>

namespace orthocone
{
/// Friction that depends on what the nodes have been through: Friction/Factor at each node, from the state
/// before a step, so that the law of the step is fixed (docs/theory.md, section 3, "Friction with memory").
class FrictionMemory
{
public:
  /// `scene` must outlive it.
  explicit FrictionMemory(const Scene &scene);

  bool is_there() const { return is_there_; }
  const FrictionFactor &factor() const { return factor_; }

  /// The factors (n) of a step behind `state` in this cycle, which may be any numbers.
  Eigen::VectorXd values(const ContactState &state, unsigned int cycle) const;

  /// The same, or nothing without memory. Throws SolveError where coefficients cannot be multiplied by one.
  Eigen::VectorXd factors(const ContactState &state, unsigned int cycle) const;

  /// Speeds (n, mm/s) in a step from `before` to `after`; empty where the factor does not depend on them.
  Eigen::VectorXd speeds(const ContactState &before, const ContactState &after, double seconds) const;

private:
  FrictionHistory history(const ContactState &state, Eigen::Index node, unsigned int cycle) const;
  void check(double factor, const ContactState &state, Eigen::Index node, unsigned int cycle) const;

  const Scene &scene_;
  FrictionFactor factor_;
  bool is_there_;
};

/// Largest change of the factor from one step to the next at a node that touches in both, relative to the
/// smaller one; 0 without memory.
double change_of_factor(const ContactState &before, const ContactState &after);

/// What a step counts as dissipated at slipping nodes (N mm) although their friction had fallen by then:
/// energy that becomes motion where friction falls at once.
double energy_of_fall(const ContactState &before, const ContactState &after);
} // namespace orthocone
