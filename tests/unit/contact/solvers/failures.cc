// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Where methods fail: the smallest problems on which a method must fail in a known way, while the default
// does not. docs/stability.md has the mechanisms.
#include "contact/contact_problems.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace
{
/// Nodes with the same law under a displacement, from no force on.
struct SmallProblem
{
  SmallProblem(const MatrixXd &w, const OrthotropicFriction &law, const NodeVector &free)
      : compliance(w),
        system(compliance, FrictionLaws(free.size() / 3, law)),
        problem(system, free)
  {
  }

  SolverReport report(const ContactSolverOptions &options) const
  {
    NodeVector force = NodeVector::Zero(3 * problem.n_nodes());
    return solve_step(problem, options, force);
  }

  Verdict verdict(const std::string &method, const unsigned int maximum_iterations = 5000) const
  {
    ContactSolverOptions options = solver_options(method, 1e-10);
    options.maximum_iterations = maximum_iterations;
    return report(options).verdict;
  }

  DenseCompliance compliance;
  ContactSystem system;
  ContactStep problem;
};

/// Nodes that move together by `coupling` of what a force on one of them does; normal and tangential
/// directions do not feel each other.
MatrixXd coupled(const Eigen::Index n, const double coupling)
{
  const MatrixXd nodes = MatrixXd::Constant(n, n, coupling) + (1 - coupling) * MatrixXd::Identity(n, n);
  MatrixXd w = MatrixXd::Zero(3 * n, 3 * n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      w.block<3, 3>(3 * i, 3 * j) = nodes(i, j) * Matrix3d::Identity();
  return w;
}

/// One node, a compliance that couples all directions, and a slip rule far off the friction ellipse.
SmallProblem cycling_newton()
{
  Matrix3d w;
  w << 2.06, 1.13, -2.07, 1.13, 4.42, -2.14, -2.07, -2.14, 7.43;
  return SmallProblem(w, {0.88, 0.186, 0.689, 1.45}, Vector3d(-0.67, 0.2, 0.035));
}

/// Two nodes; single nodes, with the force of the other held, have several solutions.
SmallProblem cycling_sweeps()
{
  MatrixXd w(6, 6);
  w << 3.644, -0.401, -1.574, 1.404, 0.572, -1.540, //
      -0.401, 11.367, 1.621, -1.204, -4.118, 2.812, //
      -1.574, 1.621, 16.930, -1.256, 5.862, 0.967,  //
      1.404, -1.204, -1.256, 5.594, -0.176, -1.395, //
      0.572, -4.118, 5.862, -0.176, 9.841, -2.248,  //
      -1.540, 2.812, 0.967, -1.395, -2.248, 3.865;
  NodeVector free(6);
  free << -0.572, -0.002, -0.326, -0.501, 0.512, -0.507;
  return SmallProblem(w, {0.872, 2.85, 1.07, 0.93}, free);
}
} // namespace

// While all nodes stick, Box 3 for all nodes at once is r <- r - rho (q + W r), which converges just for
// rho lambda_max(W) < 2; here lambda_max = 1 + (n - 1) coupling, and rho = factor.
TEST(Failures, Box3DivergesJustWhereRhoTimesLambdaExceedsTwo)
{
  const OrthotropicFriction sticky{10, 10, 10, 10};
  for (const Eigen::Index n : {3, 6, 12})
  {
    const SmallProblem nodes(coupled(n, 0.9), sticky, Vector3d(-1, 0.1, 0.2).replicate(n, 1));
    const double limit = 2 / (1 + 0.9 * static_cast<double>(n - 1));
    for (const double share : {0.5, 0.95, 1.05, 2.})
    {
      ContactSolverOptions options = solver_options("box3", 1e-10);
      options.maximum_iterations = 5000;
      options.rho_factor = share * limit;
      EXPECT_EQ(nodes.report(options).converged, share < 1) << n << " nodes, " << share << " of the limit";
    }
    EXPECT_EQ(nodes.verdict("newton"), Verdict::converged);
  }
}

// The same nodes one after the other: Gauss-Seidel converges for every positive definite W.
TEST(Failures, Feng2006SurvivesTheCouplingThatBreaksBox3)
{
  const SmallProblem nodes(coupled(6, 0.9), {10, 10, 10, 10}, Vector3d(-1, 0.1, 0.2).replicate(6, 1));
  EXPECT_NE(nodes.verdict("box3"), Verdict::converged);
  EXPECT_EQ(nodes.verdict("feng2006"), Verdict::converged);
}

TEST(Failures, Feng2006CyclesOnANodeThatIsSofterAlongThanAcross)
{
  const SmallProblem node(Vector3d(1, 1, 2.5).asDiagonal().toDenseMatrix(), case_a, Vector3d(-1, 0, 0.1));
  EXPECT_EQ(node.verdict("feng2006"), Verdict::cycling);
  EXPECT_EQ(node.verdict("newton"), Verdict::converged);
}

TEST(Failures, PlainNewtonCyclesOnOneNode)
{
  EXPECT_EQ(cycling_newton().verdict("plain-newton"), Verdict::cycling);
  EXPECT_EQ(cycling_newton().verdict("newton"), Verdict::converged);
}

// What one node takes from the others is almost what they lack: each sweep moves the forces by a little.
TEST(Failures, SweepsAreSlowWhereAllNodesMoveTogether)
{
  const SmallProblem nodes(coupled(5, 0.98), case_b, Vector3d(-1, 0.3, 0.2).replicate(5, 1));
  EXPECT_EQ(nodes.verdict("gauss-seidel", 300), Verdict::slow);
  EXPECT_EQ(nodes.verdict("newton", 300), Verdict::converged);
}

TEST(Failures, SweepsCycleWhereSingleNodesHaveSeveralSolutions)
{
  EXPECT_EQ(cycling_sweeps().verdict("gauss-seidel"), Verdict::cycling);
  EXPECT_EQ(cycling_sweeps().verdict("newton"), Verdict::converged);
}
} // namespace orthocone::test
