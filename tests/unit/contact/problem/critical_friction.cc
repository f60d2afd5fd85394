// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/contact_problems.h"

#include <orthocone/contact/law/one_node.h>
#include <orthocone/contact/problem/critical_friction.h>

#include <gtest/gtest.h>

#include <random>

namespace orthocone::test
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{
OrthotropicFriction isotropic(const double mu)
{
  return {mu, mu, mu, mu};
}

/// A node whose normal displacement follows forces along x; y is held.
Matrix3d coupled_block(const double coupling)
{
  Matrix3d w = Vector3d(2, 3, 1).asDiagonal();
  w(0, 1) = w(1, 0) = coupling;
  return w;
}

/// Positive definite, all directions coupled.
Matrix3d random_block(std::mt19937 &generator)
{
  std::normal_distribution<double> normal;
  Matrix3d root;
  for (int i = 0; i < 9; ++i)
    root(i / 3, i % 3) = normal(generator);
  return root * root.transpose() + 0.3 * Matrix3d::Identity();
}

/// Load under which the node is stuck at the border of its cone where it also slips by `slip`, with a normal
/// force so large that the curvature of the cone does not matter; and both forces.
struct TwoStates
{
  TwoStates(const OrthotropicFriction &law, const Matrix3d &w, const Eigen::Vector2d &slip)
  {
    constexpr double large = 1e6;
    const Vector3d change(0, slip[0], slip[1]);
    const Eigen::Vector2d traction = sliding_traction(law, slip[0], slip[1]);
    slipping = large * Vector3d(1, traction[0], traction[1]);
    stuck = slipping - w.inverse() * change;
    load = -w * stuck;
  }
  Vector3d load, slipping, stuck;
};

/// Whether some direction of slip gives two solutions.
bool has_two_solutions(const OrthotropicFriction &law, const Matrix3d &w)
{
  const DenseCompliance compliance(w);
  const ContactSystem system(compliance, {law});
  for (double angle = 0; angle < 6.2832; angle += 0.01)
  {
    const TwoStates states(law, w, {std::cos(angle), std::sin(angle)});
    const ContactStep problem(system, step_displacement(states.load, Vector3d::Zero()));
    if (problem.residual(states.slipping) < 1e-12 && problem.residual(states.stuck) < 1e-12)
      return true;
  }
  return false;
}

OrthotropicFriction scaled(const OrthotropicFriction &law, const double factor)
{
  return {factor * law.mu_x, factor * law.mu_y, law.p_x, law.p_y};
}
} // namespace

TEST(CriticalFriction, IsTheRatioOfCompliancesForAPlaneNode)
{
  for (const double coupling : {0.5, -1.2})
    EXPECT_NEAR(critical_friction_factor(isotropic(0.4), coupled_block(coupling)),
                2 / (0.4 * std::abs(coupling)), 1e-12);
  EXPECT_EQ(critical_friction_factor(isotropic(0.4), coupled_block(0)),
            std::numeric_limits<double>::infinity());
}

TEST(CriticalFriction, ScalesWithTheInverseOfFrictionAndNotWithThatOfSlip)
{
  std::mt19937 generator(3);
  const Matrix3d w = random_block(generator);
  const double factor = critical_friction_factor(case_b, w);
  EXPECT_NEAR(critical_friction_factor(scaled(case_b, 5), w), factor / 5, 1e-9 * factor);
  EXPECT_NEAR(critical_friction_factor(OrthotropicFriction{0.3, 0.15, 3, 1.5}, w), factor, 1e-12 * factor);
  EXPECT_NEAR(critical_friction_factor(case_b, 1e-6 * w), factor, 1e-9 * factor);
}

TEST(CriticalFriction, SecondSolutionsOfANodeBeginThere)
{
  std::mt19937 generator(5);
  for (const OrthotropicFriction &law : {case_a, case_b, OrthotropicFriction{0.3, 0.15, 0.2, 0.2}})
    for (int i = 0; i < 20; ++i)
    {
      const Matrix3d w = random_block(generator);
      const double factor = critical_friction_factor(law, w);
      if (factor == 0)
        continue;
      EXPECT_TRUE(has_two_solutions(scaled(law, 1.02 * factor), w)) << factor << "\n" << w;
      EXPECT_FALSE(has_two_solutions(scaled(law, 0.98 * factor), w)) << factor << "\n" << w;
    }
}

// The slip rule may lead a node across the force that resists it, so that two states exist without any
// coupling to the normal force.
TEST(CriticalFriction, IsZeroWhereTheSlipRuleAloneIsEnough)
{
  Matrix3d w = Matrix3d::Identity();
  w(1, 2) = w(2, 1) = 0.5;
  w(0, 1) = w(1, 0) = 0.01;
  EXPECT_GT(critical_friction_factor(case_b, w), 1);
  EXPECT_EQ(critical_friction_factor(case_c, w), 0);
  EXPECT_TRUE(has_two_solutions(case_c, w));
  EXPECT_TRUE(has_two_solutions(scaled(case_c, 1e-2), w));
}

TEST(CriticalFriction, NamesTheNode)
{
  Eigen::MatrixXd w = Eigen::MatrixXd::Identity(9, 9);
  for (int node = 0; node < 3; ++node)
    w.block<3, 3>(3 * node, 3 * node) = coupled_block(node == 1 ? 1 : 0.5);
  const DenseCompliance compliance(w);
  const CriticalFriction critical = critical_friction(ContactSystem(compliance, {3, isotropic(0.4)}));
  EXPECT_EQ(critical.node, 1);
  EXPECT_NEAR(critical.factor, 5, 1e-12);
}

// Two independent nodes, pressed down and lifted by the coupling with x: open, or wedged, at the same load.
TEST(CriticalFriction, AboveItTwoStartsEndAtDifferentTrueSolutions)
{
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(6, 6);
  w.block<3, 3>(0, 0) = w.block<3, 3>(3, 3) = coupled_block(1);
  const DenseCompliance compliance(w);
  NodeVector load(6);
  load << 0.01, 1.4, 0, 0.01, 1.4, 0;
  for (const double factor : {0.5, 0.9, 1.1, 1.5})
  {
    const ContactSystem system(compliance, {2, isotropic(2 * factor)}); // wedges from 2 on
    EXPECT_NEAR(critical_friction(system).factor, 1 / factor, 1e-12);
    const ContactStep problem(system, step_displacement(load, NodeVector::Zero(6)));
    const NodeVector stuck = -w.inverse() * load;
    EXPECT_LE(problem.residual(NodeVector::Zero(6)), 1e-12);
    EXPECT_EQ(problem.residual(stuck) < 1e-12, factor > 1) << factor;
    NodeVector found = stuck;
    EXPECT_TRUE(solve_step(problem, solver_options("newton"), found).converged);
    EXPECT_EQ(found.norm() > 0, factor > 1) << factor;
  }
}

// Beyond it the one-node solution still is a true one, even where the node wedges.
TEST(CriticalFriction, OneNodeIsSolvedBeyondIt)
{
  std::mt19937 generator(11);
  for (const OrthotropicFriction &law : {case_a, case_b, case_c})
    for (int i = 0; i < 100; ++i)
    {
      const Matrix3d w = random_block(generator);
      const DenseCompliance compliance(w);
      for (const double factor : {1., 10., 100.})
      {
        const ContactSystem system(compliance, {scaled(law, factor)});
        for (const Vector3d &q : directions())
        {
          const ContactStep problem(system, step_displacement(q, Vector3d::Zero()));
          const OneNodeProblem node{w, w.inverse()};
          EXPECT_LE(problem.residual(solve_one_node(problem.law(0), node, q, Vector3d::Zero())), 1e-9)
              << factor << " mu " << law.mu_x << " " << law.mu_y << "\n"
              << w << "\nq " << q.transpose();
        }
      }
    }
}
} // namespace orthocone::test
