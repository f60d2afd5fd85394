// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/solvers/newton/inexact_newton.h"
#include "contact/contact_problems.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
/// Iterations of a step that takes back a share of the load, from the state under all of it.
SolverReport unloaded(const GridProblem &grid, const double share)
{
  NodeVector force = grid.zero();
  solve_step(grid.problem, solver_options("newton", 1e-12), force);
  const NodeVector slip = grid.problem.displacement(force);
  NodeVector free = (1 - share) * grid.problem.q();
  for (Eigen::Index node = 0; node < grid.problem.n_nodes(); ++node)
    free.segment<2>(3 * node + 1) -= slip.segment<2>(3 * node + 1);
  return make_inexact_newton(grid.system, solver_options("newton", 1e-10))
      ->solve(ContactStep(grid.system, free), force);
}
} // namespace

/// Where slip is far from associated, the map has minima beside the solutions. A method that reduces it with
/// every step needs 13.6 iterations here in the mean, and does not solve one of the steps.
TEST(InexactNewton, CrossesRidgesBesideTheSolution)
{
  unsigned int iterations = 0, n_steps = 0;
  for (const double push : {0.25, 0.5, 1., 2., 4.})
  {
    const GridProblem grid({0.3, 0.15, 1. / 64, 1}, 7, push);
    for (const double share : {0.1, 0.2, 0.3, 0.4, 0.5})
    {
      const SolverReport report = unloaded(grid, share);
      EXPECT_TRUE(report.converged) << push << " " << share;
      iterations += report.iterations;
      ++n_steps;
    }
  }
  EXPECT_LE(iterations, 11 * n_steps);
}

/// A node whose slip would go with friction sticks, and breaks loose when it does. Newton's steps go to and
/// fro with it, to the 60th of the first two cases and the 38th of the third one.
TEST(InexactNewton, SolvesNodesThatStickAndSlipInTurnsExactly)
{
  struct Case
  {
    double p_x;
    unsigned int n;
  };
  for (const auto &[p_x, n] : {Case{1. / 32, 7}, Case{1. / 128, 7}, Case{1. / 128, 5}})
  {
    const SolverReport report = unloaded(GridProblem({0.3, 0.15, p_x, 1}, n, 4), 0.1);
    EXPECT_TRUE(report.converged) << p_x << " " << n;
    EXPECT_LE(report.iterations, 25u) << p_x << " " << n;
  }
}
} // namespace orthocone::test
