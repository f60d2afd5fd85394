// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/compliance/compliance.h>

#include <utility>

namespace orthocone
{
DenseCompliance::DenseCompliance(Eigen::MatrixXd matrix)
    : matrix_(std::move(matrix))
{
  eigen_assert(matrix_.rows() == matrix_.cols() && matrix_.rows() % 3 == 0);
}

void DenseCompliance::vmult(NodeVector &displacement, const NodeVector &force) const
{
  displacement.noalias() = matrix_.selfadjointView<Eigen::Lower>() * force;
}

Eigen::Matrix3d DenseCompliance::diagonal_block(const Eigen::Index node) const
{
  return matrix_.block<3, 3>(3 * node, 3 * node);
}
} // namespace orthocone
