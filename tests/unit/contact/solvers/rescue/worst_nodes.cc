// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/solvers/rescue/worst_nodes.h"
#include "contact/contact_problems.h"
#include "contact/solvers/newton/linearization.h"

#include <orthocone/surface/exact_compliance.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;

TEST(WorstNodes, AreThoseThatHoldNearlyAllOfTheError)
{
  const GridProblem grid({0.3, 0.15, 0.05, 0.2}, 5, 1);
  NodeVector force = grid.zero();
  solve_step(grid.problem, solver_options("newton", 1e-12), force);
  NodeVector displacement = grid.problem.displacement(force);
  displacement[3 * 12] -= 1; // these press
  displacement[3 * 11] -= 0.5;
  displacement[3 * 13] -= 0.01;
  EXPECT_EQ(worst_nodes(grid.problem, force, displacement, 8), (std::vector<Index>{12, 11}));
  EXPECT_EQ(worst_nodes(grid.problem, force, displacement, 1), (std::vector<Index>{12}));
  EXPECT_EQ(entries_of({12, 11}), (std::vector<Index>{36, 37, 38, 33, 34, 35}));
}

TEST(WorstNodes, TheDominantOneHoldsNearlyAllOfTheError)
{
  const GridProblem grid({0.3, 0.15, 0.05, 0.2}, 5, 1);
  NodeVector force = grid.zero();
  solve_step(grid.problem, solver_options("newton", 1e-12), force);
  constexpr Index hard = 12, second = 11; // both press
  NodeVector displacement = grid.problem.displacement(force);
  displacement[3 * hard] -= 1;
  EXPECT_EQ(dominant_node(grid.problem, force, displacement), hard);
  displacement[3 * second] -= 1;
  EXPECT_FALSE(dominant_node(grid.problem, force, displacement));
}

TEST(WorstNodes, ObeyLinearizedLawsOnAComplianceThatIsNotSymmetric)
{
  GridProblem grid({0.3, 0.15, 0.05, 0.2}, 5, 1);
  NodeVector force = grid.zero();
  solve_step(grid.problem, solver_options("newton", 1e-12), force);
  for (Index node = 0; node < grid.problem.n_nodes(); ++node)
    force.segment<3>(3 * node) *= 1 + 0.2 * static_cast<double>(node % 3);
  const NodeVector displacement = grid.problem.displacement(force);
  const ContactConditions conditions = linearize(grid.problem, force, displacement).conditions;
  MatrixXd matrix = *grid.system.compliance().dense();
  matrix = MatrixXd(matrix.selfadjointView<Eigen::Lower>());
  const double skew = 0.01 * matrix.norm() / static_cast<double>(matrix.rows());
  for (Index i = 1; i < matrix.rows(); ++i)
  {
    matrix(i, i - 1) += skew;
    matrix(i - 1, i) -= skew;
  }
  const UnsymmetricCompliance compliance(matrix);
  const NodeVector change = compliance.condition_solver(1)->solve(conditions, 1).force;
  const NodeVector moved = matrix * change;
  for (Index node = 0; node < grid.problem.n_nodes(); ++node)
    EXPECT_LE(lacking_of(conditions.nodes[node], change.segment<3>(3 * node), moved.segment<3>(3 * node)),
              1e-10 * change.norm())
        << node;
}
} // namespace orthocone::test
