// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>

namespace orthocone
{
/// 1 / sqrt(b) for every row of a matrix W (3 n x 3 n), with the largest diagonal entry b of its node's 3 x 3
/// block. Nodes that hardly move are taken as if they moved by 1e-10 of the softest one.
NodeVector block_scale(const DenseView &w);

/// How far the entries of W are from their mirror images, relative to the blocks of their nodes:
/// |w_ij - w_ji| / sqrt(b_i b_j). Both are 0 where the largest one is 1e-8 or less.
struct MirrorDifference
{
  double largest = 0;
  double norm = 0; ///< Frobenius norm of (W - W^T) / 2 in this scale, which bounds the error of eigenvalues
};

/// Throws std::invalid_argument, whose message begins with "W is not symmetric", where the largest difference
/// is more than 1e-3. That is more than matrices in single precision have of rounding.
MirrorDifference mirror_difference(const DenseView &w);

/// (W + W^T) / 2.
Eigen::MatrixXd symmetric_part(const DenseView &w);
} // namespace orthocone
