// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The residual is relative to what costs force: what costs none must not make it lax.
#include "contact/contact_problems.h"

#include <orthocone/contact/problem/law_errors.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
using Eigen::Index;

constexpr double far = 1e6; // the other displacements are about 1
constexpr double spoiled_by = 1.01;

NodeVector solution(const ContactStep &step)
{
  NodeVector force = NodeVector::Zero(3 * step.n_nodes());
  EXPECT_TRUE(solve_step(step, solver_options("newton", 1e-13), force).converged);
  return force;
}

LawErrors errors_of(const ContactStep &step, const NodeVector &force)
{
  return law_errors(step, force, step.displacement(force));
}

/// The same wrong forces have the same errors in both steps.
void expect_same_errors(const ContactStep &step, const ContactStep &other, const NodeVector &right)
{
  const NodeVector wrong = spoiled_by * right;
  EXPECT_GT(step.residual(wrong), 1e-3);
  EXPECT_NEAR(other.residual(wrong) / step.residual(wrong), 1, 1e-6);
  const LawErrors first = errors_of(step, wrong), second = errors_of(other, wrong);
  EXPECT_GT(first.complementarity, 1e-4);
  EXPECT_NEAR(second.complementarity / first.complementarity, 1, 1e-6);
  EXPECT_NEAR(second.penetration, first.penetration, 1e-6 * first.penetration);
}
} // namespace

// Nodes that stay open are a kilometre away, and move by another one along the plane.
TEST(Residual, DoesNotCountGapsThatNeverClose)
{
  const GridProblem grid(case_b);
  const NodeVector right = solution(grid.problem);
  NodeVector q = grid.problem.q();
  unsigned int n_open = 0;
  for (Index node = 0; node < grid.problem.n_nodes(); ++node)
    if (right.segment<3>(3 * node).norm() == 0)
    {
      q.segment<3>(3 * node) += Eigen::Vector3d(far, far, -far);
      ++n_open;
    }
  ASSERT_GT(n_open, 0u);
  const ContactStep other(grid.system, q);
  EXPECT_LE(other.residual(right), 1e-11);
  expect_same_errors(grid.problem, other, right);
}

// Without friction a slide costs nothing, however long it is.
TEST(Residual, DoesNotCountFreeSlides)
{
  const GridProblem grid({0, 0, 1, 1});
  const NodeVector right = solution(grid.problem);
  NodeVector q = grid.problem.q();
  for (Index node = 0; node < grid.problem.n_nodes(); ++node)
    q[3 * node + 1] += far;
  const ContactStep other(grid.system, q);
  EXPECT_LE(other.residual(right), 1e-11);
  expect_same_errors(grid.problem, other, right);
}
} // namespace orthocone::test
