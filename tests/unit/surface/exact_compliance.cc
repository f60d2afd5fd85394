// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/exact_compliance.h>

#include <gtest/gtest.h>

#include <array>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
/// Open, slipping and stuck nodes with relations at random.
ContactConditions some_conditions(const Index n_nodes, const Index n_motions)
{
  ContactConditions conditions;
  for (Index i = 0; i < n_nodes; ++i)
  {
    NodeCondition node;
    node.n_unknowns = std::array<Index, 3>{{3, 2, 0}}[i % 3];
    node.basis = Eigen::Matrix3d::Random().colwise().normalized();
    node.rows = node.basis + 0.2 * Eigen::Matrix3d::Random();
    node.diagonal = node.n_unknowns == 2 ? Eigen::Vector3d(0, 0.7, 0) : Eigen::Vector3d(0, 0, 0);
    node.right_side.setRandom();
    if (node.n_unknowns < 3)
      node.fixed.setRandom();
    conditions.nodes.push_back(node);
  }
  if (n_motions > 0)
    conditions.face =
        Eigen::HouseholderQR<MatrixXd>(MatrixXd::Random(3 * n_nodes, n_motions)).householderQ() *
        MatrixXd::Identity(3 * n_nodes, n_motions);
  conditions.face_right_side = VectorXd::Random(n_motions);
  return conditions;
}

/// Largest error of a change in its conditions, N.
double error_of(const ContactConditions &conditions, const MatrixXd &w, const ContactChange &change)
{
  NodeVector displacement = w * change.force;
  double error = 0;
  if (conditions.face.cols() > 0)
  {
    displacement += conditions.face * change.face;
    error = (conditions.face.transpose() * change.force - conditions.face_right_side).norm();
  }
  Index place = 0;
  for (const NodeCondition &node : conditions.nodes)
  {
    const Index n = node.n_unknowns;
    const Eigen::Vector3d force = change.force.segment<3>(place) - node.fixed;
    const MatrixXd basis = node.basis.leftCols(n);
    const VectorXd x = n == 0 ? VectorXd(0) : VectorXd(basis.colPivHouseholderQr().solve(force));
    error = std::max(error, (force - basis * x).norm());
    if (n > 0)
      error = std::max(error, (node.rows.leftCols(n).transpose() * displacement.segment<3>(place) +
                               node.diagonal.head(n).cwiseProduct(x) - node.right_side.head(n))
                                  .norm());
    place += 3;
  }
  return error;
}
} // namespace

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
