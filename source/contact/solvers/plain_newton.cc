// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "linearization.h"
#include "solvers.h"

namespace orthocone
{
PlainNewton::PlainNewton(const ContactSystem &system, const ContactSolverOptions &options)
    : options_(options),
      conditions_(condition_solver(system, "plain-newton"))
{
}

SolverReport PlainNewton::solve(const ContactStep &step, Eigen::VectorXd &unknowns) const
{
  constexpr unsigned int iterations_between_checks = 1;
  constexpr double inexactness = 1e-4; // what single precision gives without trouble
  const auto iterate = [&](Eigen::VectorXd &x)
  {
    x += newton_change(*conditions_, linearize(step, x, step.displacement(x), options_.rho_factor),
                       inexactness);
  };
  return iterate_until_converged(step, options_, iterations_between_checks, unknowns, iterate);
}
} // namespace orthocone
