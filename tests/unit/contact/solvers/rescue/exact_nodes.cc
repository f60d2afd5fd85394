// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/solvers/rescue/exact_nodes.h"
#include "contact/contact_problems.h"
#include "contact/solvers/newton/linearization.h"
#include "contact/solvers/solvers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::Vector3d;

namespace
{
/// Newton's step of a grid whose nodes stick, slip and open, from forces that are no solution.
struct NewtonStep
{
  NewtonStep()
      : grid({0.3, 0.15, 0.05, 0.2}, 5, 1),
        force(grid.zero())
  {
    solve_step(grid.problem, solver_options("newton", 1e-12), force);
    for (Index node = 0; node < grid.problem.n_nodes(); ++node)
      force.segment<3>(3 * node) *= 1 + 0.2 * static_cast<double>(node % 3);
    displacement = grid.problem.displacement(force);
    conditions = linearize(grid.problem, force, displacement).conditions;
    solver = condition_solver(grid.system, "newton");
    change = with_displacement(grid.problem, solver->solve(conditions, 1e-12));
  }

  /// Part of the natural map behind a change, N.
  Vector3d error(const ContactChange &of, const Index node) const
  {
    return grid.problem.natural_map(force + of.force, displacement + of.displacement).segment<3>(3 * node);
  }

  /// What the conditions of a node lack, N.
  double lacking(const ContactChange &of, const Index node) const
  {
    return lacking_of(conditions.nodes[node], of.force.segment<3>(3 * node),
                      of.displacement.segment<3>(3 * node));
  }

  GridProblem grid;
  NodeVector force, displacement;
  ContactConditions conditions;
  std::unique_ptr<ConditionSolver> solver;
  ContactChange change;
};
} // namespace

namespace
{
/// Groups of so many nodes that follow each other obey their laws, and all others their conditions.
void expect_exact(const NewtonStep &step, const Index size)
{
  constexpr double exact_to = 1e-9, accuracy = 1e-2; // of the solutions for a force at a node
  const Index n = step.grid.problem.n_nodes();
  double missed = 0;
  for (Index first = 0; first + size <= n; ++first)
  {
    std::vector<Index> nodes;
    for (Index node = first; node < first + size; ++node)
      nodes.push_back(node);
    const auto exact = with_exact_nodes(step.grid.problem, step.force, step.displacement, step.conditions,
                                        *step.solver, step.change, nodes);
    ASSERT_TRUE(exact) << first;
    const double moved = (exact->force - step.change.force).norm();
    for (Index node = 0; node < n; ++node)
      if (std::find(nodes.begin(), nodes.end(), node) != nodes.end())
      {
        EXPECT_LE(step.error(*exact, node).norm(), exact_to * step.force.norm()) << first << " " << node;
        missed = std::max(missed, step.error(step.change, node).norm());
      }
      else
      {
        EXPECT_LE(step.lacking(*exact, node), accuracy * moved + exact_to * step.force.norm())
            << first << " " << node;
      }
  }
  EXPECT_GT(missed, 1e-3 * step.force.norm()); // by Newton's step alone
}
} // namespace

TEST(ExactNodes, OneObeysItsLawAndLeavesTheOthersTheirConditions)
{
  expect_exact(NewtonStep(), 1);
}

TEST(ExactNodes, SeveralObeyTheirLawsAndLeaveTheOthersTheirConditions)
{
  for (const Index size : {2, 4, 8})
    expect_exact(NewtonStep(), size);
}
} // namespace orthocone::test
