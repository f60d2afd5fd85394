// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>

#include <cstdint>

namespace orthocone
{
/// A symmetric matrix whose entries have 16 bits, for products that need no more than four digits. Half of it
/// is stored, in square tiles with a scale each: an entry is off by at most 2e-5 of the largest one of its
/// tile. A large matrix does not fit into the caches, and a product takes as long as its memory is read.
class RoundedMatrix
{
public:
  /// Rounds the lower half of `matrix` / `scale`.
  RoundedMatrix(const DenseView &matrix, double scale);

  /// The product with a vector, by product_threads().
  Eigen::VectorXf operator*(const Eigen::VectorXf &vector) const;

  /// The same by so many threads. Its last digits depend on their number alone.
  Eigen::VectorXf product(const Eigen::VectorXf &vector, Eigen::Index n_threads) const;

private:
  /// What every `stride`-th column of tiles from `first` on adds to the product, with whole tiles.
  Eigen::VectorXf product_of_columns(const Eigen::VectorXf &x, Eigen::Index first, Eigen::Index stride) const;

  Eigen::Index size_;
  std::vector<std::int16_t> entries_; ///< tile by tile, column by column of the lower half
  std::vector<float> units_;          ///< of the entries, one a tile
};
} // namespace orthocone
