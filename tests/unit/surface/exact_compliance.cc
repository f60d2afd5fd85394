// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/exact_compliance.h>

#include "some_conditions.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// W holds some directions a million times less than others: single precision would know nothing of them.
TEST(ExactCompliance, SolvesConditionsToRounding)
{
  std::srand(1);
  for (const Index n_motions : {0, 2})
    for (const Index n_nodes : {4, 41})
    {
      const MatrixXd motions = MatrixXd::Random(3 * n_nodes, 6);
      const ExactCompliance compliance(motions * motions.transpose() +
                                       1e-6 * MatrixXd::Identity(3 * n_nodes, 3 * n_nodes));
      const ContactConditions conditions = some_conditions(n_nodes, n_motions);
      const auto change = compliance.condition_solver(compliance.softness())->solve(conditions, 0.01);
      EXPECT_LT(error_of(conditions, *compliance.dense(), change), 1e-6) << n_nodes << ' ' << n_motions;
      EXPECT_EQ(change.face.size(), n_motions);
    }
}

/// Forces that little resists, as those of nearly incompressible bodies, are hidden from GMRES in single
/// precision. Elimination takes its place.
TEST(DenseCompliance, EliminatesWhatGmresDoesNotSolve)
{
  std::srand(1);
  constexpr Index n_nodes = 90; // too many to be eliminated at once
  const MatrixXd base =
      Eigen::HouseholderQR<MatrixXd>(MatrixXd::Random(3 * n_nodes, 3 * n_nodes)).householderQ();
  const VectorXd eigenvalues =
      VectorXd::LinSpaced(3 * n_nodes, 0, -7).unaryExpr([](const double x) { return std::pow(10, x); });
  const DenseCompliance compliance(base * eigenvalues.asDiagonal() * base.transpose());
  for (const Index n_motions : {0, 2})
  {
    const ContactConditions conditions = some_conditions(n_nodes, n_motions);
    const auto change = compliance.condition_solver(compliance.softness())->solve(conditions, 1e-4);
    EXPECT_LT(error_of(conditions, *compliance.dense(), change), 1e-6) << n_motions;
  }
}

TEST(ExactCompliance, GivenForcesNeedNoSolution)
{
  ContactConditions conditions;
  conditions.nodes.resize(2);
  conditions.nodes[1].fixed = Eigen::Vector3d(1, 2, 3);
  const ExactCompliance compliance(MatrixXd::Identity(6, 6));
  const auto change = compliance.condition_solver(1)->solve(conditions, 0.01);
  EXPECT_EQ(change.force, (VectorXd(6) << 0, 0, 0, 1, 2, 3).finished());
}

TEST(ExactCompliance, ASingularSystemIsNotFinite)
{
  ContactConditions conditions;
  conditions.nodes.resize(1);
  conditions.nodes[0].n_unknowns = 3;
  conditions.nodes[0].basis = conditions.nodes[0].rows = Eigen::Matrix3d::Identity();
  conditions.nodes[0].right_side.setOnes();
  const ExactCompliance compliance(MatrixXd(Eigen::Vector3d(1, 1, 0).asDiagonal()));
  EXPECT_FALSE(compliance.condition_solver(1)->solve(conditions, 0.01).force.allFinite());
}
} // namespace orthocone::test
