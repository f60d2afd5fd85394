// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/contact_problems.h"
#include "contact/laws.h"

#include <orthocone/base/text.h>
#include <orthocone/contact/law/natural_map.h>
#include <orthocone/contact/law/one_node.h>
#include <orthocone/contact/problem/critical_friction.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Vector3d;

namespace
{
const OrthotropicFriction none{0, 0, 1, 1};

NodeVector solution(const OrthotropicFriction &law, const std::string &method)
{
  const GridProblem grid(law);
  NodeVector force = grid.zero();
  const SolverReport report = solve_step(grid.problem, solver_options(method), force);
  EXPECT_TRUE(report.converged) << "method " << method << " " << law.mu_x << " residual " << report.residual;
  return force;
}
} // namespace

// The cone is the half-line r_t = 0, r_n >= 0.
TEST(Frictionless, ProjectionIsThatOnTheNormal)
{
  for (const Vector3d &tau : {Vector3d(2, 0, 0), Vector3d(2, -3, 1), Vector3d(1e-9, 5, 5)})
  {
    EXPECT_EQ(project(none, tau), Vector3d(tau[0], 0, 0));
    EXPECT_EQ(admissible_force(none, tau), Vector3d(tau[0], 0, 0));
    EXPECT_FALSE(TrialForce(none, 1, tau, Vector3d::Zero()).sticks());
  }
  EXPECT_EQ(project(none, {-1, 3, 0}), Vector3d::Zero());
  EXPECT_EQ(project(none, {0, 3, 0}), Vector3d::Zero());
  EXPECT_EQ(modified_displacement(none, {0.5, 3, -4}), Vector3d(0.5, 0, 0)); // slip costs nothing
}

TEST(Frictionless, ANodeIsPressedBackByItsNormalForceAlone)
{
  Eigen::Matrix3d compliance;
  compliance << 2, 0.5, -0.3, 0.5, 1, 0.1, -0.3, 0.1, 1.5;
  const OneNodeProblem problem{compliance, compliance.inverse()};
  const Vector3d q(-1, 7, -3);
  EXPECT_EQ(solve_one_node(none, problem, q, Vector3d::Zero()), Vector3d(0.5, 0, 0));
  EXPECT_EQ(solve_one_node(none, problem, {1, 7, -3}, Vector3d::Ones()), Vector3d::Zero());
  EXPECT_EQ(critical_friction_factor(none, compliance), std::numeric_limits<double>::infinity());
}

// The limit of small friction: tangential forces vanish with mu, and the rest converges to the answer
// without.
TEST(Frictionless, IsTheLimitOfSmallFriction)
{
  for (const char *const method : {"newton", "gauss-seidel", "uzawa", "plain-newton", "feng2006"})
  {
    const NodeVector without = solution(none, method);
    EXPECT_GT(without.norm(), 0);
    for (Eigen::Index node = 0; node < without.size() / 3; ++node)
      EXPECT_LE(without.segment<2>(3 * node + 1).norm(), 1e-16);
    double last = std::numeric_limits<double>::infinity();
    for (const double mu : {1e-2, 1e-4, 1e-6})
    {
      const double difference = (solution({mu, mu, mu, mu}, method) - without).norm() / without.norm();
      EXPECT_LT(difference, 0.05 * last);
      last = difference;
    }
    EXPECT_LT(last, 1e-5);
  }
}
} // namespace orthocone::test
