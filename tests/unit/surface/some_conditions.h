// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/condition_solver.h>

#include <array>

namespace orthocone::test
{
/// Open, slipping and stuck nodes with relations at random.
inline ContactConditions some_conditions(const Eigen::Index n_nodes, const Eigen::Index n_motions)
{
  ContactConditions conditions;
  for (Eigen::Index i = 0; i < n_nodes; ++i)
  {
    NodeCondition node;
    node.n_unknowns = std::array<Eigen::Index, 3>{{3, 2, 0}}[i % 3];
    node.basis = Eigen::Matrix3d::Random().colwise().normalized();
    node.rows = node.basis + 0.2 * Eigen::Matrix3d::Random();
    node.diagonal = node.n_unknowns == 2 ? Eigen::Vector3d(0, 0.7, 0) : Eigen::Vector3d(0, 0, 0);
    node.right_side.setRandom();
    if (node.n_unknowns < 3)
      node.fixed.setRandom();
    conditions.nodes.push_back(node);
  }
  if (n_motions > 0)
    conditions.face = Eigen::HouseholderQR<Eigen::MatrixXd>(Eigen::MatrixXd::Random(3 * n_nodes, n_motions))
                          .householderQ() *
                      Eigen::MatrixXd::Identity(3 * n_nodes, n_motions);
  conditions.face_right_side = Eigen::VectorXd::Random(n_motions);
  return conditions;
}

/// Largest error of a change in its conditions, N.
inline double error_of(const ContactConditions &conditions, const Eigen::MatrixXd &w,
                       const ContactChange &change)
{
  NodeVector displacement = w * change.force;
  double error = 0;
  if (conditions.face.cols() > 0)
  {
    displacement += conditions.face * change.face;
    error = (conditions.face.transpose() * change.force - conditions.face_right_side).norm();
  }
  Eigen::Index place = 0;
  for (const NodeCondition &node : conditions.nodes)
  {
    const Eigen::Index n = node.n_unknowns;
    const Eigen::Vector3d force = change.force.segment<3>(place) - node.fixed;
    const Eigen::MatrixXd basis = node.basis.leftCols(n);
    const Eigen::VectorXd x =
        n == 0 ? Eigen::VectorXd(0) : Eigen::VectorXd(basis.colPivHouseholderQr().solve(force));
    error = std::max(error, (force - basis * x).norm());
    if (n > 0)
      error = std::max(error, (node.rows.leftCols(n).transpose() * displacement.segment<3>(place) +
                               node.diagonal.head(n).cwiseProduct(x) - node.right_side.head(n))
                                  .norm());
    place += 3;
  }
  return error;
}
} // namespace orthocone::test
