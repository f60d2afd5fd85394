// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "dense_conditions.h"

#include "direct_conditions.h"

#include <utility>

namespace orthocone
{
DenseConditionSolver::DenseConditionSolver(const DenseView &compliance, const double softness)
    : compliance_(compliance),
      softness_(softness)
{
}

ContactChange DenseConditionSolver::solve(const ContactConditions &conditions, const double accuracy) const
{
  constexpr Eigen::Index most_rows = 3000;
  if (auto change = solve_directly(conditions, compliance_, softness_))
    return *std::move(change);
  if (!inner_)
    inner_ = std::make_unique<InnerCompliance>(compliance_, softness_);
  IterativeChange solution = solve_by_gmres(conditions, *inner_, accuracy);
  // Newton's steps that are far from exact stall (docs/performance.md).
  if (!solution.converged && compliance_.rows() <= most_rows)
    if (auto change = eliminate(conditions, compliance_, softness_))
      return *std::move(change);
  return std::move(solution.change);
}
} // namespace orthocone
