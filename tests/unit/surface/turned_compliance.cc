// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/turned_compliance.h>

#include <orthocone/surface/grid_half_space.h>

#include <gtest/gtest.h>

#include <vector>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
constexpr HalfSpace turned_body{1000, 0.25};
const SurfaceGrid turned_grid{5, 4, 0.5, 0.4};

/// Every node has axes of its own, some with a normal that is not z.
LocalAxes many_axes()
{
  std::vector<Eigen::Matrix3d> frames;
  for (Index node = 0; node < turned_grid.n_nodes(); ++node)
  {
    const double angle = static_cast<double>(node);
    frames.emplace_back(Eigen::AngleAxisd(0.1 * angle, Eigen::Vector3d(1, angle, 0).normalized()) *
                        axes_about_z(17 * angle));
  }
  return LocalAxes(frames);
}

MatrixXd matrix_of(const Compliance &compliance)
{
  const Index n = 3 * compliance.n_nodes();
  MatrixXd matrix(n, n);
  VectorXd column;
  for (Index i = 0; i < n; ++i)
  {
    compliance.vmult(column, VectorXd::Unit(n, i));
    matrix.col(i) = column;
  }
  return matrix;
}

/// T, block by block: local components to (z, x, y).
MatrixXd turns_of(const LocalAxes &axes)
{
  const Index n = turned_grid.n_nodes();
  MatrixXd turns = MatrixXd::Zero(3 * n, 3 * n);
  for (Index node = 0; node < n; ++node)
    turns.block<3, 3>(3 * node, 3 * node) =
        axes_about_z(0).transpose() * axes.global_in_local(static_cast<std::size_t>(node));
  return turns;
}
} // namespace

TEST(TurnedCompliance, IsTheTurnedMatrix)
{
  const LocalAxes axes = many_axes();
  const TurnedCompliance turned(std::make_unique<const GridHalfSpace>(turned_grid, turned_body), axes);
  const MatrixXd turns = turns_of(axes),
                 expected = turns.transpose() * matrix_of(GridHalfSpace(turned_grid, turned_body)) * turns,
                 found = matrix_of(turned);
  EXPECT_LT((found - expected).norm(), 1e-13 * expected.norm());
  EXPECT_LT((turned.diagonal_block(7) - expected.block<3, 3>(21, 21)).norm(), 1e-13 * expected.norm());
  const VectorXd force = VectorXd::LinSpaced(expected.cols(), -1, 2);
  EXPECT_LT((turned.displacement_at(6, force) - (expected * force).segment<3>(18)).norm(),
            1e-12 * (expected * force).norm());
}

// Forces that give the nodes these displacements, and on some nodes none, in turned axes; the face moves all
// nodes along one direction until the forces there are in balance.
TEST(TurnedCompliance, SolvesConditionsInItsOwnAxes)
{
  const LocalAxes axes = many_axes();
  const TurnedCompliance turned(std::make_unique<const GridHalfSpace>(turned_grid, turned_body), axes);
  const MatrixXd w = matrix_of(turned);
  const Index n = w.rows();
  ContactConditions conditions;
  const VectorXd wanted = VectorXd::LinSpaced(n, 0.01, 0.02).array().sin();
  std::vector<Index> held;
  for (Index node = 0; node < turned_grid.n_nodes(); ++node)
  {
    NodeCondition condition;
    if (node % 4 != 0)
    {
      condition.n_unknowns = 3;
      condition.basis.setIdentity();
      condition.rows = 100 * Eigen::Matrix3d::Identity();
      condition.right_side = 100 * wanted.segment<3>(3 * node);
      for (Index d = 0; d < 3; ++d)
        held.push_back(3 * node + d);
    }
    conditions.nodes.push_back(condition);
  }
  conditions.face = VectorXd::LinSpaced(n, -1, 1).normalized();
  conditions.face_right_side = VectorXd::Constant(1, 0.3);
  const auto m = static_cast<Index>(held.size());
  MatrixXd system = MatrixXd::Zero(m + 1, m + 1);
  VectorXd right(m + 1);
  system.topLeftCorner(m, m) = w(held, held);
  system.topRightCorner(m, 1) = conditions.face(held, 0);
  system.bottomLeftCorner(1, m) = system.topRightCorner(m, 1).transpose();
  right << wanted(held), 0.3;
  const VectorXd exact = system.fullPivLu().solve(right);
  const ContactChange change = turned.condition_solver(turned.softness())->solve(conditions, 1e-5);
  EXPECT_LT((change.force(held) - exact.head(m)).norm(), 1e-3 * exact.head(m).norm());
  EXPECT_NEAR(change.face[0], exact[m], 1e-3 * std::abs(exact[m]));
}
} // namespace orthocone::test
