// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "inner_compliance.h"

#include <orthocone/surface/condition_solver.h>

namespace orthocone
{
/// Solves conditions of contact nodes on a dense compliance: few unknowns directly, and many by GMRES in
/// single precision, whose errors Newton's next iteration corrects. Only one thread at a time may use it.
class DenseConditionSolver : public ConditionSolver
{
public:
  /// `compliance` must outlive the solver; `softness`: its largest eigenvalue.
  DenseConditionSolver(const DenseView &compliance, double softness);

  ContactChange solve(const ContactConditions &conditions, double accuracy) const override;

private:
  const DenseView &compliance_;
  double softness_;
  mutable std::unique_ptr<InnerCompliance> inner_{}; ///< made where it is needed first
};
} // namespace orthocone
