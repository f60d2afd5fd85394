// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <vector>

namespace orthocone
{
/// Copies the lower half of a square matrix to the upper one.
void mirror_lower_half(Eigen::MatrixXd &matrix);

/// Moves row k and column k of a square matrix to targets[k]. `targets` is a permutation. Beside the matrix
/// it takes the memory of one column.
void move_rows_and_columns(Eigen::MatrixXd &matrix, const std::vector<Eigen::Index> &targets);
} // namespace orthocone
