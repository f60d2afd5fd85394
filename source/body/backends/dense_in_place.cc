// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "dense_in_place.h"

#include <algorithm>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Tile by tile: columns alone would miss the caches.
void mirror_lower_half(MatrixXd &matrix)
{
  constexpr Index width = 64;
  for (Index j = 0; j < matrix.cols(); j += width)
    for (Index i = j; i < matrix.rows(); i += width)
      for (Index column = j; column < std::min(j + width, matrix.cols()); ++column)
        for (Index row = std::max(i, column + 1); row < std::min(i + width, matrix.rows()); ++row)
          matrix(column, row) = matrix(row, column);
}

void move_rows_and_columns(MatrixXd &matrix, const std::vector<Index> &targets)
{
  std::vector<bool> is_done(targets.size(), false);
  VectorXd carried(matrix.rows());
  for (Index first = 0; first < matrix.cols(); ++first)
  {
    if (is_done[first])
      continue;
    carried = matrix.col(first);
    Index k = first;
    do
    {
      k = targets[k];
      carried.swap(matrix.col(k));
      is_done[k] = true;
    } while (k != first);
  }
  for (Index column = 0; column < matrix.cols(); ++column)
  {
    carried = matrix.col(column);
    for (Index row = 0; row < matrix.rows(); ++row)
      matrix(targets[row], column) = carried[row];
  }
}
} // namespace orthocone
