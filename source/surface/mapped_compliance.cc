// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/mortar.h>

#include <algorithm>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;

MatrixXd mapped_compliance(const Eigen::SparseMatrix<double> &map, const DenseView &compliance)
{
  // Few rows at a time stay in the cache. Sums run over entries that lie side by side.
  constexpr Index most_rows = 16;
  const Eigen::SparseMatrix<double> across = map.transpose();
  const Index n = map.rows();
  MatrixXd mapped(n, n);
  for (Index first = 0; first < n; first += most_rows)
  {
    const Index n_rows = std::min(most_rows, n - first), rest = n - first - n_rows;
    const MatrixXd half = compliance * across.middleCols(first, n_rows);
    const MatrixXd turned = half.transpose();
    const MatrixXd rows = turned * across.rightCols(n - first);
    mapped.block(first, first, n_rows, n_rows) = rows.leftCols(n_rows).selfadjointView<Eigen::Upper>();
    mapped.block(first, first + n_rows, n_rows, rest) = rows.rightCols(rest);
    mapped.block(first + n_rows, first, rest, n_rows) = rows.rightCols(rest).transpose();
  }
  return mapped;
}
} // namespace orthocone
