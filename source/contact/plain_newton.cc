// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "newton_system.h"
#include "solvers.h"

namespace orthocone
{
PlainNewton::PlainNewton(const ContactProblem &problem, const ContactSolverOptions &options)
    : problem_(problem),
      options_(options),
      inner_(dense_compliance(problem, "plain-newton"), problem.largest_compliance())
{
}

SolverReport PlainNewton::solve(NodeVector &force)
{
  constexpr unsigned int iterations_between_checks = 1;
  constexpr float inexactness = 1e-4F; // what single precision gives without trouble
  const auto iterate = [this](NodeVector &r)
  {
    const NewtonSystem system(problem_, r, problem_.displacement(r), options_.rho_factor);
    r += system.solve(inner_, inexactness);
  };
  return iterate_until_converged(problem_, options_, iterations_between_checks, force, iterate);
}
} // namespace orthocone
