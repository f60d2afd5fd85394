// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/solvers/rescue/nonlinear_elimination.h"
#include "contact/contact_problems.h"

#include <gtest/gtest.h>

#include <array>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
constexpr OrthotropicFriction turning_law{0.3, 0.15, 0.1, 0.3}; // slip is not associated
constexpr double of_sweeps = 1e-10;                             // tolerance

std::unique_ptr<ContactSolver> make_sweeps(const ContactSystem &system, const ContactSolverOptions &options)
{
  ContactSolverOptions sweeps = options;
  sweeps.method = "gauss-seidel";
  sweeps.maximum_iterations = 10000;
  return make_contact_solver(system, sweeps);
}

/// A grid of n x n nodes with the forces that solve its step.
struct LargeSolvedGrid
{
  explicit LargeSolvedGrid(const Index n)
      : grid(turning_law, n),
        force(grid.zero())
  {
    EXPECT_TRUE(solve_step(grid.problem, solver_options("gauss-seidel", of_sweeps), force).converged);
  }

  NonlinearElimination::Result solved_from(const VectorXd &start) const
  {
    const NonlinearElimination elimination(solver_options("newton", of_sweeps), make_sweeps);
    return elimination.solve(grid.problem, start, grid.problem.displacement(start));
  }

  GridProblem grid;
  VectorXd force;
};
} // namespace

// Where the gap of two nodes changes, no other node notices until forces do.
TEST(NonlinearElimination, TheLawHoldsOnThemAndTheirNeighbours)
{
  const LargeSolvedGrid solved(18);
  NodeVector q = solved.grid.problem.q();
  const std::array<Index, 2> changed{{170, 171}};
  for (const Index node : changed)
    q.segment<3>(3 * node) += Eigen::Vector3d(-0.3, 0.1, -0.2);
  const ContactStep step(solved.grid.system, q);
  const auto map = [&](const VectorXd &force) { return step.natural_map(force, step.displacement(force)); };
  ASSERT_GT(map(solved.force).norm(), 1e-2 * solved.force.norm());
  const NonlinearElimination elimination(solver_options("newton", of_sweeps), make_sweeps);
  const auto result = elimination.solve(step, solved.force, step.displacement(solved.force));
  ASSERT_TRUE(result.unknowns);
  const VectorXd rest = map(*result.unknowns);
  for (const Index node : changed)
    for (const Index near : {node, node + 1, node - 1, node + 18, node - 18})
      EXPECT_LT(rest.segment<3>(3 * near).norm(), 10 * of_sweeps * solved.force.norm()) << near;
}

TEST(NonlinearElimination, OtherForcesStayAsTheyAre)
{
  const LargeSolvedGrid solved(18);
  VectorXd wrong = solved.force;
  wrong.segment<3>(0) += Eigen::Vector3d(0.5, 0, 0);
  const Index far = 3 * (18 * 18 - 1);
  const auto result = solved.solved_from(wrong);
  ASSERT_TRUE(result.unknowns);
  EXPECT_EQ(result.unknowns->segment<3>(far), wrong.segment<3>(far));
}

TEST(NonlinearElimination, WhatIsWrongEverywhereIsLeftAlone)
{
  const LargeSolvedGrid solved(18);
  EXPECT_FALSE(solved.solved_from(0.9 * solved.force).unknowns);
}

TEST(NonlinearElimination, SmallSurfacesHaveNoSmallProblem)
{
  const LargeSolvedGrid solved(5);
  VectorXd wrong = solved.force;
  wrong.segment<3>(0) += Eigen::Vector3d(0.5, 0, 0);
  EXPECT_FALSE(solved.solved_from(wrong).unknowns);
}
} // namespace orthocone::test
