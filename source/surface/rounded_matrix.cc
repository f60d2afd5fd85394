// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rounded_matrix.h"

#include <orthocone/base/every_processor.h>
#include <orthocone/base/threads.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <future>
#include <limits>

namespace orthocone
{
namespace
{
using Eigen::Index;
using Eigen::VectorXf;

constexpr int width = 64; // of a tile: its entries and vectors fit into the first cache
constexpr Index entries_of_tile = Index{width} * width;

Index n_tiles(const Index size)
{
  return (size + width - 1) / width;
}

/// Numbers that a processor takes at once.
template<int n>
struct Register
{
  typedef float Values __attribute__((vector_size(4 * n)));
  typedef std::int32_t Integers __attribute__((vector_size(4 * n)));
};

template<int n>
ORTHOCONE_INLINE void read(typename Register<n>::Values &to, const std::int16_t *const from)
{
  typename Register<n>::Integers integers; // of this loop gcc makes one instruction, of a conversion several
  for (int k = 0; k < n; ++k)
    integers[k] = from[k];
  to = __builtin_convertvector(integers, typename Register<n>::Values);
}

/// Adds up lanes until four are left.
template<int n>
ORTHOCONE_INLINE void fold(typename Register<4>::Values &to, const typename Register<n>::Values &from)
{
  typename Register<4>::Values parts[n / 4];
  std::memcpy(parts, &from, sizeof from);
  to = parts[0];
  for (int i = 1; i < n / 4; ++i)
    to += parts[i];
}

/// A column of the next tile: the processor itself does not look ahead beyond a page of memory.
ORTHOCONE_INLINE void prefetch(const std::int16_t *const column)
{
  constexpr int entries_of_line = 32; // 64 bytes
  for (int i = 0; i < width; i += entries_of_line)
    __builtin_prefetch(column + i);
}

/// Of a tile below the diagonal: y_row += unit tile x_column and y_column += unit tile^T x_row.
template<int n>
ORTHOCONE_INLINE void add_products_in_lanes(const std::int16_t *const tile, const float unit,
                                            const float *const x_row, const float *const x_column,
                                            float *const y_row, float *const y_column)
{
  using Values = typename Register<n>::Values;
  constexpr int n_parts = width / n; // of a column
  Values sums[n_parts] = {}, scaled[n_parts];
  std::memcpy(scaled, x_row, sizeof scaled);
  for (Values &part : scaled)
    part *= unit;
  typename Register<4>::Values dots[width];
  for (int j = 0; j < width; ++j)
  {
    const std::int16_t *const column = tile + j * width;
    prefetch(column + entries_of_tile);
    const float x = unit * x_column[j];
    Values dot{};
    for (int i = 0; i < n_parts; ++i)
    {
      Values entries;
      read<n>(entries, column + i * n);
      sums[i] += x * entries;
      dot += scaled[i] * entries;
    }
    fold<n>(dots[j], dot);
  }
  for (int j = 0; j < width; ++j)
    y_column[j] += (dots[j][0] + dots[j][1]) + (dots[j][2] + dots[j][3]);
  for (int i = 0; i < width; ++i)
    y_row[i] += sums[i / n][i % n];
}

#ifdef ORTHOCONE_FOR_PROCESSOR
ORTHOCONE_FOR_PROCESSOR("avx512f")
void add_products(const std::int16_t *const tile, const float unit, const float *const x_row,
                  const float *const x_column, float *const y_row, float *const y_column)
{
  add_products_in_lanes<16>(tile, unit, x_row, x_column, y_row, y_column);
}

ORTHOCONE_FOR_PROCESSOR("fma")
void add_products(const std::int16_t *const tile, const float unit, const float *const x_row,
                  const float *const x_column, float *const y_row, float *const y_column)
{
  add_products_in_lanes<8>(tile, unit, x_row, x_column, y_row, y_column);
}

ORTHOCONE_FOR_PROCESSOR("default")
#endif
void add_products(const std::int16_t *const tile, const float unit, const float *const x_row,
                  const float *const x_column, float *const y_row, float *const y_column)
{
  add_products_in_lanes<4>(tile, unit, x_row, x_column, y_row, y_column);
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
  entries_.reserve(static_cast<std::size_t>((n * (n + 1) / 2 + 1) * entries_of_tile));
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
  entries_.resize(entries_.size() + entries_of_tile); // for looking ahead
}

VectorXf RoundedMatrix::operator*(const VectorXf &vector) const
{
  return product(vector, product_threads(size_));
}

VectorXf RoundedMatrix::product(const VectorXf &vector, const Index n_threads) const
{
  VectorXf x = VectorXf::Zero(n_tiles(size_) * width);
  x.head(size_) = vector;
  std::vector<std::future<VectorXf>> others;
  for (Index thread = 1; thread < n_threads; ++thread) // computed below where no thread is to be had
    others.push_back(std::async([&, thread] { return product_of_columns(x, thread, n_threads); }));
  VectorXf y = product_of_columns(x, 0, n_threads);
  for (std::future<VectorXf> &other : others)
    y += other.get();
  return y.head(size_);
}

VectorXf RoundedMatrix::product_of_columns(const VectorXf &x, const Index first, const Index stride) const
{
  const Index n = n_tiles(size_);
  VectorXf y = VectorXf::Zero(x.size());
  for (Index j = first; j < n; j += stride)
    for (Index i = j; i < n; ++i)
    {
      const Index k = j * n - j * (j - 1) / 2 + i - j;
      const std::int16_t *const tile = entries_.data() + k * entries_of_tile;
      const float unit = units_[static_cast<std::size_t>(k)];
      if (i == j)
        add_diagonal_product(tile, unit, x.data() + i * width, y.data() + i * width);
      else
        add_products(tile, unit, x.data() + i * width, x.data() + j * width, y.data() + i * width,
                     y.data() + j * width);
    }
  return y;
}
} // namespace orthocone
