// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rounded_matrix.h"

#include <orthocone/base/every_processor.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthocone
{
namespace
{
using Eigen::Index;
using Eigen::VectorXf;

constexpr int width = 64; // of a tile: its entries and vectors fit into the first cache
constexpr int lanes = 16; // numbers that a processor takes at once, at most
constexpr int columns_at_once = 4;
constexpr Index entries_of_tile = Index{width} * width;

Index n_tiles(const Index size)
{
  return (size + width - 1) / width;
}

/// Of a tile below the diagonal: y_row += unit tile x_column and y_column += unit tile^T x_row.
ORTHOCONE_FOR_EVERY_PROCESSOR
void add_products(const std::int16_t *const tile, const float unit, const float *const x_row,
                  const float *const x_column, float *const y_row, float *const y_column)
{
  float sums[width] = {}, scaled[width];
  for (int i = 0; i < width; ++i)
    scaled[i] = unit * x_row[i];
  for (int j = 0; j < width; j += columns_at_once)
  {
    const std::int16_t *const a = tile + j * width, *const b = a + width, *const c = b + width,
                              *const d = c + width;
    const float x_a = unit * x_column[j], x_b = unit * x_column[j + 1], x_c = unit * x_column[j + 2],
                x_d = unit * x_column[j + 3];
    float dot_a[lanes] = {}, dot_b[lanes] = {}, dot_c[lanes] = {}, dot_d[lanes] = {};
    for (int i = 0; i < width; i += lanes)
      for (int k = 0; k < lanes; ++k)
      {
        const float e_a = a[i + k], e_b = b[i + k], e_c = c[i + k], e_d = d[i + k];
        sums[i + k] += e_a * x_a + e_b * x_b + e_c * x_c + e_d * x_d;
        dot_a[k] += e_a * scaled[i + k];
        dot_b[k] += e_b * scaled[i + k];
        dot_c[k] += e_c * scaled[i + k];
        dot_d[k] += e_d * scaled[i + k];
      }
    for (int k = 0; k < lanes; ++k)
    {
      y_column[j] += dot_a[k];
      y_column[j + 1] += dot_b[k];
      y_column[j + 2] += dot_c[k];
      y_column[j + 3] += dot_d[k];
    }
  }
  for (int i = 0; i < width; ++i)
    y_row[i] += sums[i];
}

/// The same of a tile on the diagonal, which is whole.
ORTHOCONE_FOR_EVERY_PROCESSOR
void add_diagonal_product(const std::int16_t *const tile, const float unit, const float *const x,
                          float *const y)
{
  for (int j = 0; j < width; ++j)
    for (int i = 0; i < width; ++i)
      y[i] += unit * x[j] * tile[j * width + i];
}
} // namespace

RoundedMatrix::RoundedMatrix(const DenseView &matrix, const double scale)
    : size_(matrix.rows())
{
  constexpr double largest_number = std::numeric_limits<std::int16_t>::max();
  const Index n = n_tiles(size_);
  entries_.reserve(static_cast<std::size_t>(n * (n + 1) / 2 * entries_of_tile));
  for (Index j = 0; j < n; ++j)
    for (Index i = j; i < n; ++i)
    {
      const Index row = i * width, column = j * width;
      Eigen::MatrixXd tile = Eigen::MatrixXd::Zero(width, width);
      const Index n_rows = std::min<Index>(width, size_ - row),
                  n_columns = std::min<Index>(width, size_ - column);
      tile.topLeftCorner(n_rows, n_columns) = matrix.block(row, column, n_rows, n_columns) / scale;
      if (i == j)
        tile.triangularView<Eigen::StrictlyUpper>() = tile.transpose();
      const double largest = tile.cwiseAbs().maxCoeff();
      const double unit = largest > 0 ? largest / largest_number : 1;
      const Eigen::ArrayXX<std::int16_t> rounded = (tile.array() / unit).round().cast<std::int16_t>();
      entries_.insert(entries_.end(), rounded.data(), rounded.data() + entries_of_tile);
      units_.push_back(static_cast<float>(unit));
    }
}

VectorXf RoundedMatrix::operator*(const VectorXf &vector) const
{
  const Index n = n_tiles(size_);
  VectorXf x = VectorXf::Zero(n * width), y = VectorXf::Zero(n * width);
  x.head(size_) = vector;
  std::size_t k = 0;
  for (Index j = 0; j < n; ++j)
    for (Index i = j; i < n; ++i, ++k)
    {
      const std::int16_t *const tile = entries_.data() + k * entries_of_tile;
      if (i == j)
        add_diagonal_product(tile, units_[k], x.data() + i * width, y.data() + i * width);
      else
        add_products(tile, units_[k], x.data() + i * width, x.data() + j * width, y.data() + i * width,
                     y.data() + j * width);
    }
  return y.head(size_);
}
} // namespace orthocone
