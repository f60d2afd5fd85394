// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "grid_transform.h"

#include <orthocone/base/numbers.h>

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <type_traits>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;

namespace
{
constexpr Index n_fields = 3;              ///< normal, x, y
constexpr Index least_for_threads = 16384; ///< nodes; with fewer, threads take longer to start than to work

/// FFTW's functions for a precision, by one name each.
template<typename Real>
struct Fftw;

template<>
struct Fftw<double>
{
  using Plan = fftw_plan;
  using Complex = fftw_complex;
  static constexpr auto plan_forward = fftw_plan_dft_r2c_1d;
  static constexpr auto plan_backward = fftw_plan_dft_c2r_1d;
  static constexpr auto plan_columns = fftw_plan_many_dft;
  static constexpr auto forward = fftw_execute_dft_r2c;
  static constexpr auto backward = fftw_execute_dft_c2r;
  static constexpr auto columns = fftw_execute_dft;
  static constexpr auto destroy = fftw_destroy_plan;
  static constexpr auto free = fftw_free;
  static constexpr auto allocate = fftw_malloc;
};

template<>
struct Fftw<float>
{
  using Plan = fftwf_plan;
  using Complex = fftwf_complex;
  static constexpr auto plan_forward = fftwf_plan_dft_r2c_1d;
  static constexpr auto plan_backward = fftwf_plan_dft_c2r_1d;
  static constexpr auto plan_columns = fftwf_plan_many_dft;
  static constexpr auto forward = fftwf_execute_dft_r2c;
  static constexpr auto backward = fftwf_execute_dft_c2r;
  static constexpr auto columns = fftwf_execute_dft;
  static constexpr auto destroy = fftwf_destroy_plan;
  static constexpr auto free = fftwf_free;
  static constexpr auto allocate = fftwf_malloc;
};

/// The least number from n on that has no prime factors but 2, 3, 5 and 7, for which FFTW is fast.
Index fast_size(Index n)
{
  const auto is_fast = [](Index rest)
  {
    for (const Index factor : {2, 3, 5, 7})
      while (rest % factor == 0)
        rest /= factor;
    return rest == 1;
  };
  while (!is_fast(n))
    ++n;
  return n;
}

/// Calls `work` for the numbers from 0 to n, each thread for a range of its own.
template<typename Work>
void in_threads(const unsigned int n_threads, const Index n, const Work &work)
{
  const auto range = [&](const Index i)
  {
    for (Index k = i * n / n_threads; k < (i + 1) * n / n_threads; ++k)
      work(k);
  };
  std::vector<std::thread> threads;
  for (unsigned int i = 1; i < n_threads; ++i)
    threads.emplace_back(range, i);
  range(0);
  for (std::thread &thread : threads)
    thread.join();
}
} // namespace

/// Three fields whose rows are padded, their spectra, and the ways between them. Rows, and blocks of columns,
/// begin at the same alignment, so that one plan serves all of them.
template<typename Real>
struct GridTransform<Real>::Plans
{
  using Own = Fftw<Real>;
  using Complex = typename Own::Complex;
  template<typename Value>
  using Memory = std::unique_ptr<Value, void (*)(void *)>;
  using Plan = std::unique_ptr<std::remove_pointer_t<typename Own::Plan>, void (*)(typename Own::Plan)>;

  static constexpr Index columns_at_once = 8; ///< as many numbers as lie in one line of the cache

  static Index aligned(const Index n)
  {
    return (n + columns_at_once - 1) / columns_at_once * columns_at_once;
  }

  template<typename Value>
  static Memory<Value> zeros(const Index n)
  {
    const std::size_t n_bytes = sizeof(Value) * static_cast<std::size_t>(n);
    void *const values = Own::allocate(n_bytes);
    std::memset(values, 0, n_bytes);
    return {static_cast<Value *>(values), Own::free};
  }

  Plans(const Index given_rows, const Index size_x, const Index size_y, const Index n_frequencies)
      : n_rows(given_rows),
        n_columns(size_y),
        length(2 * aligned((size_x + 1) / 2)),
        width(aligned(n_frequencies)),
        field(zeros<Real>(n_fields * n_rows * length)),
        spectrum(zeros<Complex>(n_fields * size_y * width)),
        row_forward(nullptr, Own::destroy),
        row_backward(nullptr, Own::destroy),
        column_forward(nullptr, Own::destroy),
        column_backward(nullptr, Own::destroy)
  {
    // Plans that are measured would differ from run to run.
    const auto n_x = static_cast<int>(size_x), n_y = static_cast<int>(size_y),
               apart = static_cast<int>(width);
    const auto columns = [&](const int direction)
    {
      return Own::plan_columns(1, &n_y, columns_at_once, spectrum.get(), nullptr, apart, 1, spectrum.get(),
                               nullptr, apart, 1, direction, FFTW_ESTIMATE);
    };
    row_forward.reset(Own::plan_forward(n_x, field.get(), spectrum.get(), FFTW_ESTIMATE));
    row_backward.reset(Own::plan_backward(n_x, spectrum.get(), field.get(), FFTW_ESTIMATE));
    column_forward.reset(columns(FFTW_FORWARD));
    column_backward.reset(columns(FFTW_BACKWARD));
  }

  Real *row(const Index f, const Index y) const { return field.get() + (f * n_rows + y) * length; }
  Complex *spectrum_row(const Index f, const Index q) const
  {
    return spectrum.get() + (f * n_columns + q) * width;
  }

  Index n_blocks() const { return width / columns_at_once; }

  /// Transforms a block of columns of a field, in place.
  void transform(const Plan &columns, const Index f, const Index block) const
  {
    Complex *const first = spectrum_row(f, 0) + block * columns_at_once;
    Own::columns(columns.get(), first, first);
  }

  Index n_rows, n_columns; ///< of the grid, and of the padded grid
  Index length, width;     ///< from row to row of field and spectrum
  Memory<Real> field;
  Memory<Complex> spectrum;
  Plan row_forward, row_backward, column_forward, column_backward;
};

template<typename Real>
GridTransform<Real>::GridTransform(const SurfaceGrid &grid, const unsigned int n_threads)
    : grid_(grid),
      padded_x_(grid.is_periodic ? grid.n_x : fast_size(2 * grid.n_x)),
      padded_y_(grid.is_periodic ? grid.n_y : fast_size(2 * grid.n_y)),
      n_frequencies_(padded_x_ / 2 + 1),
      n_threads_(grid.n_nodes() < least_for_threads ? 1 : n_threads),
      plans_(std::make_unique<Plans>(grid.n_y, padded_x_, padded_y_, n_frequencies_))
{
}

template<typename Real>
GridTransform<Real>::~GridTransform() = default;

/// The wave numbers of the frequencies p and q; those of the upper half of q are negative.
template<typename Real>
Eigen::Vector2d GridTransform<Real>::wave_numbers(const Index p, const Index q) const
{
  const Index signed_q = 2 * q > padded_y_ ? q - padded_y_ : q;
  return {2 * pi * static_cast<double>(p) / (static_cast<double>(padded_x_) * grid_.width),
          2 * pi * static_cast<double>(signed_q) / (static_cast<double>(padded_y_) * grid_.height)};
}

namespace
{
/// An entry of a 3 x 3 block, and where its kernel changes sign.
struct Entry
{
  Index row, column;
  bool is_odd_in_x, is_odd_in_y;
  double GridSymbol<double>::*value;

  bool is_imaginary() const { return is_odd_in_x != is_odd_in_y; }
};

/// In two groups of as many as there are fields.
constexpr std::array<std::array<Entry, n_fields>, 2> all_entries{
    {{{{0, 0, false, false, &GridSymbol<double>::nn},
       {1, 1, false, false, &GridSymbol<double>::xx},
       {2, 2, false, false, &GridSymbol<double>::yy}}},
     {{{1, 2, true, true, &GridSymbol<double>::xy},
       {0, 1, true, false, &GridSymbol<double>::nx},
       {0, 2, false, true, &GridSymbol<double>::ny}}}}};
} // namespace

/// Fills the fields with entries of a kernel that is known where both distances are not negative: the entries
/// between x and y are odd in both, those of (n, x) and (n, y) in one.
template<typename Real>
GridSymbols<double> GridTransform<Real>::symbols(const Kernel &block_at) const
{
  std::vector<Matrix3d> blocks;
  for (Index j = 0; j < grid_.n_y; ++j)
    for (Index i = 0; i < grid_.n_x; ++i)
      blocks.push_back(block_at(i, j));
  GridSymbols<double> symbols(n_frequencies_ * padded_y_);
  for (const auto &entries : all_entries)
  {
    for (Index f = 0; f < n_fields; ++f)
      for (Index row = 0; row < padded_y_; ++row)
      {
        const Entry &entry = entries[f];
        const Index y = 2 * row < padded_y_ ? row : row - padded_y_;
        Real *const values = plans_->row(0, 0);
        std::fill_n(values, padded_x_, Real(0));
        for (Index x = 1 - grid_.n_x; x < grid_.n_x && std::abs(y) < grid_.n_y; ++x)
        {
          const bool changes = (entry.is_odd_in_x && x < 0) != (entry.is_odd_in_y && y < 0);
          const double value = blocks[std::abs(y) * grid_.n_x + std::abs(x)](entry.row, entry.column);
          values[(x + padded_x_) % padded_x_] = static_cast<Real>(changes ? -value : value);
        }
        Fftw<Real>::forward(plans_->row_forward.get(), values, plans_->spectrum_row(f, row));
      }
    for (Index f = 0; f < n_fields; ++f)
      for (Index block = 0; block < plans_->n_blocks(); ++block)
        plans_->transform(plans_->column_forward, f, block);
    for (Index f = 0; f < n_fields; ++f)
      for (Index q = 0; q < padded_y_; ++q)
        for (Index p = 0; p < n_frequencies_; ++p)
          symbols[q * n_frequencies_ + p].*entries[f].value =
              plans_->spectrum_row(f, q)[p][entries[f].is_imaginary() ? 1 : 0];
  }
  return symbols;
}

template<typename Real>
GridSymbols<double> GridTransform<Real>::kernel(const GridSymbols<double> &symbols) const
{
  GridSymbols<double> kernel(grid_.n_nodes());
  const double share = 1 / static_cast<double>(padded_x_ * padded_y_);
  for (const auto &entries : all_entries)
    for (Index f = 0; f < n_fields; ++f)
    {
      for (Index q = 0; q < padded_y_; ++q)
        for (Index p = 0; p < n_frequencies_; ++p)
        {
          auto &number = plans_->spectrum_row(f, q)[p];
          number[0] = number[1] = 0;
          number[entries[f].is_imaginary() ? 1 : 0] =
              static_cast<Real>(share * symbols[q * n_frequencies_ + p].*entries[f].value);
        }
      for (Index block = 0; block < plans_->n_blocks(); ++block)
        plans_->transform(plans_->column_backward, f, block);
      for (Index y = 0; y < grid_.n_y; ++y)
      {
        Real *const row = plans_->row(f, y);
        Fftw<Real>::backward(plans_->row_backward.get(), plans_->spectrum_row(f, y), row);
        for (Index x = 0; x < grid_.n_x; ++x)
          kernel[y * grid_.n_x + x].*entries[f].value = row[x];
      }
    }
  return kernel;
}

/// Transforms row y of the vector; rows of padding are zero.
template<typename Real>
void GridTransform<Real>::transform_row(const Vector &vector, const Index y) const
{
  for (Index f = 0; f < n_fields; ++f)
  {
    auto *const spectrum = plans_->spectrum_row(f, y);
    if (y >= grid_.n_y)
    {
      std::fill_n(&spectrum[0][0], 2 * plans_->width, Real(0));
      continue;
    }
    Real *const row = plans_->row(f, y);
    for (Index i = 0; i < grid_.n_x; ++i)
      row[i] = vector[n_fields * (y * grid_.n_x + i) + f];
    std::fill(row + grid_.n_x, row + padded_x_, Real(0));
    Fftw<Real>::forward(plans_->row_forward.get(), row, spectrum);
  }
}

/// Multiplies the numbers at frequencies [first, last) of row q.
template<typename Real>
void GridTransform<Real>::multiply(const GridSymbol<Real> *const symbols, const Index q, const Index first,
                                   const Index last) const
{
  using Complex = std::complex<Real>;
  const auto times_i = [](const Complex &z) { return Complex(-z.imag(), z.real()); };
  const Real share = Real(1) / static_cast<Real>(padded_x_ * padded_y_); // FFTW does not normalize
  auto *const normal = plans_->spectrum_row(0, q), *const x = plans_->spectrum_row(1, q),
              *const y = plans_->spectrum_row(2, q);
  for (Index p = first; p < last; ++p)
  {
    const GridSymbol<Real> &symbol = symbols[q * n_frequencies_ + p];
    const Complex f_n(share * normal[p][0], share * normal[p][1]), f_x(share * x[p][0], share * x[p][1]),
        f_y(share * y[p][0], share * y[p][1]);
    const Complex d_n = symbol.nn * f_n + times_i(symbol.nx * f_x + symbol.ny * f_y);
    const Complex d_x = symbol.xx * f_x + symbol.xy * f_y - times_i(symbol.nx * f_n);
    const Complex d_y = symbol.xy * f_x + symbol.yy * f_y - times_i(symbol.ny * f_n);
    normal[p][0] = d_n.real(), normal[p][1] = d_n.imag();
    x[p][0] = d_x.real(), x[p][1] = d_x.imag();
    y[p][0] = d_y.real(), y[p][1] = d_y.imag();
  }
}

/// A block of columns fits into the cache: it goes there and back at once.
template<typename Real>
void GridTransform<Real>::convolve_columns(const GridSymbols<Real> &symbols, const Index block) const
{
  const Index first = block * Plans::columns_at_once,
              last = std::min(first + Plans::columns_at_once, n_frequencies_);
  for (Index f = 0; f < n_fields; ++f)
    plans_->transform(plans_->column_forward, f, block);
  for (Index q = 0; q < padded_y_; ++q)
    multiply(symbols.data(), q, first, last);
  for (Index f = 0; f < n_fields; ++f)
    plans_->transform(plans_->column_backward, f, block);
}

template<typename Real>
void GridTransform<Real>::transform_row_back(const Index y, Vector &result) const
{
  for (Index f = 0; f < n_fields; ++f)
  {
    Real *const row = plans_->row(f, y);
    Fftw<Real>::backward(plans_->row_backward.get(), plans_->spectrum_row(f, y), row);
    for (Index i = 0; i < grid_.n_x; ++i)
      result[n_fields * (y * grid_.n_x + i) + f] = row[i];
  }
}

template<typename Real>
typename GridTransform<Real>::Vector GridTransform<Real>::product(const GridSymbols<Real> &symbols,
                                                                  const Vector &vector) const
{
  Vector result(vector.size());
  in_threads(n_threads_, padded_y_, [&](const Index y) { transform_row(vector, y); });
  in_threads(n_threads_, plans_->n_blocks(), [&](const Index block) { convolve_columns(symbols, block); });
  in_threads(n_threads_, grid_.n_y, [&](const Index y) { transform_row_back(y, result); });
  return result;
}

template class GridTransform<double>;
template class GridTransform<float>;
} // namespace orthocone
