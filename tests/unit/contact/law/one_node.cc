// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/laws.h"

#include <orthocone/contact/law/one_node.h>

#include <gtest/gtest.h>

#include <random>

namespace orthocone::test
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{
OneNodeProblem make_problem(const Matrix3d &compliance)
{
  return {compliance, compliance.inverse()};
}

/// Symmetric positive definite blocks whose coupling of normal and tangential directions does not wedge the
/// node.
Matrix3d random_compliance(std::mt19937 &generator)
{
  std::uniform_real_distribution<double> size(0.3, 3);
  std::uniform_real_distribution<double> coupling(-0.3, 0.3);
  Matrix3d w = Vector3d(size(generator), size(generator), size(generator)).asDiagonal();
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 3; ++j)
      w(i, j) = w(j, i) = coupling(generator) * std::sqrt(w(i, i) * w(j, j));
  return w;
}

/// The law as its source prints it.
double natural_map(const OrthotropicFriction &given, const OneNodeProblem &problem, const Vector3d &q,
                   const Vector3d &r)
{
  const double rho = 1 / problem.compliance.diagonal().maxCoeff();
  const Vector3d d = q + problem.compliance * r;
  const OrthotropicFriction law = normalized(given);
  return (r - project(law, r - rho * modified_displacement(law, d))).norm();
}
} // namespace

TEST(OneNode, SolvesTheLawExactlyWhateverTheLoadAndTheGuess)
{
  std::mt19937 generator(7);
  const std::vector<OrthotropicFriction> laws{
      case_a, case_b, case_c, {0.3, 0.15, 0.01, 1}, {0.3, 0.15, 1, 0.01}, {0.8, 0.05, 0.05, 0.8}};
  for (const OrthotropicFriction &law : laws)
    for (int i = 0; i < 50; ++i)
    {
      const OneNodeProblem problem = make_problem(random_compliance(generator));
      for (const Vector3d &q : directions())
        for (const Vector3d &guess : {Vector3d(0, 0, 0), Vector3d(1, 0.1, -0.1), Vector3d(1, -0.2, 0)})
          EXPECT_LE(natural_map(law, problem, q, solve_one_node(law, problem, q, guess)), 2e-12)
              << "mu " << law.mu_x << " " << law.mu_y << " p " << law.p_x << " " << law.p_y << "\nW\n"
              << problem.compliance << "\nq " << q.transpose() << "\nguess " << guess.transpose();
    }
}

TEST(OneNode, IsOpenStuckOrSlippingAsItShould)
{
  const OneNodeProblem problem = make_problem(Matrix3d::Identity());
  EXPECT_EQ(solve_one_node(case_b, problem, {0.1, 5, 5}, Vector3d::Zero()), Vector3d::Zero());
  EXPECT_EQ(solve_one_node(case_b, problem, {-1, 0.1, 0.1}, Vector3d::Zero()), Vector3d(1, -0.1, -0.1));
  // With W = 1 and associated slip the law asks for r_t with q_t + r_t = -slip, slip along (r_x/mu_x^2,
  // r_y/mu_y^2).
  const Vector3d r = solve_one_node(case_b, problem, {-1, 0, 1}, Vector3d::Zero());
  EXPECT_NEAR((r - Vector3d(1, 0, -0.15)).norm(), 0, 1e-13);
}

// A strongly non-associated law leaves an admissible arc of forces far narrower than any grid of angles.
TEST(OneNode, FindsNarrowAdmissibleArcs)
{
  for (const double ratio : {1. / 4, 1. / 16, 1. / 64})
    for (double angle = 0.001; angle < 6.28; angle += 0.0917)
    {
      const OneNodeProblem problem = make_problem(Vector3d(1, 1.2, 1.2).asDiagonal());
      const OrthotropicFriction law{0.3, 0.15, ratio, 1};
      const Vector3d q(-1, std::cos(angle), std::sin(angle));
      EXPECT_LE(natural_map(law, problem, q, solve_one_node(law, problem, q, Vector3d::Zero())), 1e-12)
          << ratio << " " << angle;
    }
}
} // namespace orthocone::test
