// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "neighbour_stiffness.h"

#include <cmath>

namespace orthocone
{
using Eigen::Index;

NeighbourStiffness::NeighbourStiffness(const Index n_nodes, const double scale)
    : scale_(scale),
      held_(n_held, n_nodes),
      holding_forces_(3 * n_held, 3 * n_nodes)
{
}

/// Forces on the nodes that move the first one by one unit in each direction and hold the others.
double NeighbourStiffness::hold(const std::vector<Index> &nodes,
                                const std::function<Eigen::Matrix3d(Index, Index)> &block)
{
  using Patch = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3 * n_held, 3 * n_held>;
  using Columns = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::ColMajor, 3 * n_held, 3>;
  const auto n = static_cast<Index>(nodes.size());
  Patch patch(3 * n, 3 * n);
  for (Index j = 0; j < n; ++j)
    for (Index i = j; i < n; ++i)
      patch.block<3, 3>(3 * i, 3 * j) =
          (block(nodes[static_cast<std::size_t>(i)], nodes[static_cast<std::size_t>(j)]) / scale_)
              .cast<float>();
  Columns forces = Columns::Identity(3 * n, 3);
  double least_pivot = 0;
  if (const Eigen::LLT<Patch> factor(patch); factor.info() == Eigen::Success)
  {
    for (Index d = 0; d < 3; ++d)
      forces.col(d) = factor.solve(forces.col(d));
    least_pivot = scale_ * std::pow(factor.matrixLLT().diagonal().minCoeff(), 2);
  }
  else // rounding, or rigid bodies
    forces = patch.selfadjointView<Eigen::Lower>().ldlt().solve(forces);
  const Index node = nodes.front();
  held_.col(node).setConstant(node);
  holding_forces_.middleCols<3>(3 * node).setZero();
  for (Index i = 0; i < n; ++i)
    held_(i, node) = nodes[static_cast<std::size_t>(i)];
  holding_forces_.block(0, 3 * node, 3 * n, 3) = forces;
  return least_pivot;
}

Eigen::VectorXf NeighbourStiffness::operator*(const Eigen::VectorXf &vector) const
{
  Eigen::VectorXf forces(vector.size());
  Eigen::Matrix<float, 3 * n_held, 1> moved;
  for (Index node = 0; node < held_.cols(); ++node)
  {
    for (Index i = 0; i < n_held; ++i)
      moved.segment<3>(3 * i) = vector.segment<3>(3 * held_(i, node));
    for (Index d = 0; d < 3; ++d)
      forces[3 * node + d] = holding_forces_.col(3 * node + d).dot(moved);
  }
  return forces;
}
} // namespace orthocone
