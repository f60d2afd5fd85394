// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "inner_compliance.h"

#include <orthocone/surface/nearest_nodes.h>

#include <vector>

namespace orthocone
{
using Eigen::Index;

InnerCompliance::InnerCompliance(const DenseView &compliance, const double scale)
    : scale_(scale),
      held_(n_held, compliance.rows() / 3),
      holding_forces_(3 * n_held, compliance.rows())
{
  constexpr Index least_rows_to_round = 500; // with fewer, rounding costs what products gain
  if (compliance.rows() >= least_rows_to_round)
    rounded_.emplace(compliance, scale);
  else
    single_ = (compliance / scale).cast<float>();
  for (Index node = 0; node < held_.cols(); ++node)
    hold(node, compliance);
}

/// Forces on the nearest nodes of `node` that move it by one unit in each direction and hold the others.
void InnerCompliance::hold(const Index node, const DenseView &compliance)
{
  using Patch = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3 * n_held, 3 * n_held>;
  using Columns = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::ColMajor, 3 * n_held, 3>;
  const std::vector<Index> nodes = nearest_nodes(compliance, node, n_held);
  const auto n = static_cast<Index>(nodes.size());
  Patch patch(3 * n, 3 * n);
  for (Index j = 0; j < n; ++j)
    for (Index i = j; i < n; ++i)
      patch.block<3, 3>(3 * i, 3 * j) =
          (compliance.block<3, 3>(3 * nodes[i], 3 * nodes[j]) / scale_).cast<float>();
  Columns forces = Columns::Identity(3 * n, 3);
  if (const Eigen::LLT<Patch> factor(patch); factor.info() == Eigen::Success)
    for (Index d = 0; d < 3; ++d)
      forces.col(d) = factor.solve(forces.col(d));
  else // rounding, or rigid bodies
    forces = patch.selfadjointView<Eigen::Lower>().ldlt().solve(forces);
  held_.col(node).setConstant(node);
  holding_forces_.middleCols<3>(3 * node).setZero();
  for (Index i = 0; i < n; ++i)
    held_(i, node) = nodes[i];
  holding_forces_.block(0, 3 * node, 3 * n, 3) = forces;
}

Eigen::VectorXf InnerCompliance::multiply_stiffness(const Eigen::VectorXf &vector) const
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
