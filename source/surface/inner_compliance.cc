// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "inner_compliance.h"

#include <orthocone/surface/nearest_nodes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace orthocone
{
using Eigen::Index;

namespace
{
/// The largest eigenvalue that errors of RoundedMatrix at random add to W or take from it, at most: every
/// tile might have the largest entry, which is on the diagonal.
double rounding_of_eigenvalues(const DenseView &compliance)
{
  const double unit = compliance.diagonal().maxCoeff() / std::numeric_limits<std::int16_t>::max();
  return 2 * unit * std::sqrt(static_cast<double>(compliance.rows()) / 12); // Wigner: 2 sigma sqrt(n)
}
} // namespace

InnerCompliance::InnerCompliance(const DenseView &compliance, const double scale)
    : compliance_(compliance),
      scale_(scale),
      held_(n_held, compliance.rows() / 3),
      holding_forces_(3 * n_held, compliance.rows())
{
  constexpr Index least_rows_to_round = 500; // with fewer, rounding costs what products gain
  double stiffest = std::numeric_limits<double>::infinity();
  for (Index node = 0; node < held_.cols(); ++node)
    stiffest = std::min(stiffest, hold(node, compliance));
  if (compliance.rows() >= least_rows_to_round && rounding_of_eigenvalues(compliance) < stiffest)
    rounded_.emplace(compliance, scale);
  else
    single_ = (compliance / scale).cast<float>();
}

/// Forces on the nearest nodes of `node` that move it by one unit in each direction and hold the others.
/// Returns the least pivot of these nodes (mm/N), the compliance of one direction where all before are held,
/// or 0 where rounding leaves none.
double InnerCompliance::hold(const Index node, const DenseView &compliance)
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
  double least_pivot = 0;
  if (const Eigen::LLT<Patch> factor(patch); factor.info() == Eigen::Success)
  {
    for (Index d = 0; d < 3; ++d)
      forces.col(d) = factor.solve(forces.col(d));
    least_pivot = scale_ * std::pow(factor.matrixLLT().diagonal().minCoeff(), 2);
  }
  else // rounding, or rigid bodies
    forces = patch.selfadjointView<Eigen::Lower>().ldlt().solve(forces);
  held_.col(node).setConstant(node);
  holding_forces_.middleCols<3>(3 * node).setZero();
  for (Index i = 0; i < n; ++i)
    held_(i, node) = nodes[i];
  holding_forces_.block(0, 3 * node, 3 * n, 3) = forces;
  return least_pivot;
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
