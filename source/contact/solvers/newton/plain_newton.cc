// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "../solvers.h"
#include "linearization.h"

namespace orthocone
{
namespace
{
/// Semismooth Newton on the natural map as in textbooks, with every step taken in full. It cycles where the
/// pieces of the map send it to and fro (docs/stability.md), and is there for study only.
class PlainNewton : public ContactSolver
{
public:
  PlainNewton(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  ContactSolverOptions options_;
  std::unique_ptr<ConditionSolver> conditions_;
};

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
  return iterate_until_converged(step, options_, iterations_between_checks, unknowns, iterate,
                                 Balance::unknown);
}
} // namespace

ContactMethod plain_newton_method()
{
  ContactMethod method{"plain-newton", "semismooth Newton's method without line search and sweeps",
                       make<PlainNewton>};
  method.rho = "1 / the largest diagonal entry of a node's compliance";
  method.is_for_study = true;
  return method;
}
} // namespace orthocone
