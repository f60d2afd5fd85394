// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "multigrid_compliance.h"

namespace orthocone
{
/// Solves linearized contact laws on the whole body above a counterface that gives way: displacements of the
/// body, contact forces and the motion of the face are unknown together.
class CounterfaceConditions : public ConditionSolver
{
public:
  /// `softness_ratio`: how much softer the counterface is than the body. The other arguments must outlive
  /// this object.
  CounterfaceConditions(const MultigridCompliance &body, const Compliance &counterface,
                        double softness_ratio);

  ContactChange solve(const ContactConditions &conditions, double accuracy) const override;

private:
  const MultigridCompliance &body_;
  const Compliance &counterface_;
  double softness_ratio_;
  std::unique_ptr<const ConditionSolver> on_counterface_;
};
} // namespace orthocone
