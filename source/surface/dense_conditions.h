// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "inner_compliance.h"

#include <orthocone/surface/condition_solver.h>

namespace orthocone
{
/// Solves conditions of contact nodes on a dense compliance by GMRES in single precision: Newton's next
/// iteration corrects its errors.
class DenseConditionSolver : public ConditionSolver
{
public:
  /// `compliance` must outlive the solver; `softness`: its largest eigenvalue.
  DenseConditionSolver(const DenseView &compliance, double softness);

  ContactChange solve(const ContactConditions &conditions, double accuracy) const override;

private:
  const DenseView &compliance_;
  InnerCompliance inner_;
};
} // namespace orthocone
