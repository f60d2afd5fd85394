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
  /// The softnesses are Compliance::softness() of both, which take products. Body and counterface must
  /// outlive this object.
  CounterfaceConditions(const MultigridCompliance &body, double softness_of_body,
                        const Compliance &counterface, double softness_of_counterface);

  ContactChange solve(const ContactConditions &conditions, double accuracy) const override;

private:
  const MultigridCompliance &body_;
  const Compliance &counterface_;
  double softness_ratio_;
  std::unique_ptr<const ConditionSolver> on_counterface_;
};
} // namespace orthocone
