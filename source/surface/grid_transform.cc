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
#include <type_traits>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;

namespace
{
constexpr Index n_fields = 3; ///< normal, x, y

/// FFTW's functions for a precision, by one name each.
template<typename Real>
struct Fftw;

template<>
struct Fftw<double>
{
  using Plan = fftw_plan;
  using Complex = fftw_complex;
  static constexpr auto forward = fftw_plan_many_dft_r2c;
  static constexpr auto backward = fftw_plan_many_dft_c2r;
  static constexpr auto execute = fftw_execute;
  static constexpr auto destroy = fftw_destroy_plan;
  static constexpr auto free = fftw_free;
  static constexpr auto allocate = fftw_malloc;
};

template<>
struct Fftw<float>
{
  using Plan = fftwf_plan;
  using Complex = fftwf_complex;
  static constexpr auto forward = fftwf_plan_many_dft_r2c;
  static constexpr auto backward = fftwf_plan_many_dft_c2r;
  static constexpr auto execute = fftwf_execute;
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
} // namespace

/// Three padded fields, their spectra, and the ways between them.
template<typename Real>
struct GridTransform<Real>::Plans
{
  using Own = Fftw<Real>;
  template<typename Value>
  using Memory = std::unique_ptr<Value, void (*)(void *)>;
  using Plan = std::unique_ptr<std::remove_pointer_t<typename Own::Plan>, void (*)(typename Own::Plan)>;

  Plans(const Index size_x, const Index size_y, const Index n_frequencies)
      : field(static_cast<Real *>(Own::allocate(sizeof(Real) * n_fields * size_x * size_y)), Own::free),
        spectrum(static_cast<typename Own::Complex *>(
                     Own::allocate(sizeof(typename Own::Complex) * n_fields * n_frequencies * size_y)),
                 Own::free),
        forward(nullptr, Own::destroy),
        backward(nullptr, Own::destroy)
  {
    const std::array<int, 2> sizes{static_cast<int>(size_y), static_cast<int>(size_x)};
    const auto distance = static_cast<int>(size_x * size_y), apart = static_cast<int>(n_frequencies * size_y);
    // Plans that are measured would differ from run to run.
    forward.reset(Own::forward(2, sizes.data(), n_fields, field.get(), nullptr, 1, distance, spectrum.get(),
                               nullptr, 1, apart, FFTW_ESTIMATE));
    backward.reset(Own::backward(2, sizes.data(), n_fields, spectrum.get(), nullptr, 1, apart, field.get(),
                                 nullptr, 1, distance, FFTW_ESTIMATE));
  }

  Memory<Real> field;
  Memory<typename Own::Complex> spectrum;
  Plan forward, backward;
};

template<typename Real>
GridTransform<Real>::GridTransform(const SurfaceGrid &grid)
    : grid_(grid),
      padded_x_(fast_size(2 * grid.n_x)),
      padded_y_(fast_size(2 * grid.n_y)),
      n_frequencies_(padded_x_ / 2 + 1),
      plans_(std::make_unique<Plans>(padded_x_, padded_y_, n_frequencies_))
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

/// Fills the fields with entries of a kernel that is known where both distances are not negative: the entries
/// between x and y are odd in both, those of (n, x) and (n, y) in one.
template<typename Real>
GridSymbols<double> GridTransform<Real>::symbols(const Kernel &block_at) const
{
  struct Entry
  {
    Index row, column;
    bool is_odd_in_x, is_odd_in_y;
    double GridSymbol<double>::*value;
  };
  constexpr Entry first[] = {{0, 0, false, false, &GridSymbol<double>::nn},
                             {1, 1, false, false, &GridSymbol<double>::xx},
                             {2, 2, false, false, &GridSymbol<double>::yy}};
  constexpr Entry second[] = {{1, 2, true, true, &GridSymbol<double>::xy},
                              {0, 1, true, false, &GridSymbol<double>::nx},
                              {0, 2, false, true, &GridSymbol<double>::ny}};
  std::vector<Matrix3d> blocks;
  for (Index j = 0; j < grid_.n_y; ++j)
    for (Index i = 0; i < grid_.n_x; ++i)
      blocks.push_back(block_at(i, j));
  const Index n = n_frequencies_ * padded_y_;
  GridSymbols<double> symbols(n);
  for (const Entry *const entries : {first, second})
  {
    std::fill_n(plans_->field.get(), n_fields * padded_x_ * padded_y_, Real(0));
    for (Index f = 0; f < n_fields; ++f)
      for (Index y = 1 - grid_.n_y; y < grid_.n_y; ++y)
        for (Index x = 1 - grid_.n_x; x < grid_.n_x; ++x)
        {
          const Entry &entry = entries[f];
          const bool changes = (entry.is_odd_in_x && x < 0) != (entry.is_odd_in_y && y < 0);
          const double value = blocks[std::abs(y) * grid_.n_x + std::abs(x)](entry.row, entry.column);
          plans_->field.get()[(f * padded_y_ + (y + padded_y_) % padded_y_) * padded_x_ +
                              (x + padded_x_) % padded_x_] = static_cast<Real>(changes ? -value : value);
        }
    Fftw<Real>::execute(plans_->forward.get());
    for (Index f = 0; f < n_fields; ++f)
      for (Index k = 0; k < n; ++k)
        symbols[k].*entries[f].value =
            plans_->spectrum.get()[f * n + k][entries[f].is_odd_in_x != entries[f].is_odd_in_y ? 1 : 0];
  }
  return symbols;
}

template<typename Real>
typename GridTransform<Real>::Vector GridTransform<Real>::product(const GridSymbols<Real> &symbols,
                                                                  const Vector &vector) const
{
  Real *const field = plans_->field.get();
  const Index area = padded_x_ * padded_y_, n = n_frequencies_ * padded_y_;
  std::fill_n(field, n_fields * area, Real(0));
  for (Index j = 0; j < grid_.n_y; ++j)
    for (Index i = 0; i < grid_.n_x; ++i)
      for (Index f = 0; f < n_fields; ++f)
        field[f * area + j * padded_x_ + i] = vector[n_fields * (j * grid_.n_x + i) + f];
  Fftw<Real>::execute(plans_->forward.get());
  auto *const spectrum = plans_->spectrum.get();
  const Real share = Real(1) / static_cast<Real>(area); // FFTW does not normalize
  for (Index k = 0; k < n; ++k)
  {
    using Complex = std::complex<Real>;
    const GridSymbol<Real> &symbol = symbols[k];
    auto *const normal = spectrum[k], *const x = spectrum[n + k], *const y = spectrum[2 * n + k];
    const Complex f_n(share * normal[0], share * normal[1]), f_x(share * x[0], share * x[1]),
        f_y(share * y[0], share * y[1]);
    const auto times_i = [](const Complex &z) { return Complex(-z.imag(), z.real()); };
    const Complex d_n = symbol.nn * f_n + times_i(symbol.nx * f_x + symbol.ny * f_y);
    const Complex d_x = symbol.xx * f_x + symbol.xy * f_y - times_i(symbol.nx * f_n);
    const Complex d_y = symbol.xy * f_x + symbol.yy * f_y - times_i(symbol.ny * f_n);
    normal[0] = d_n.real(), normal[1] = d_n.imag();
    x[0] = d_x.real(), x[1] = d_x.imag();
    y[0] = d_y.real(), y[1] = d_y.imag();
  }
  Fftw<Real>::execute(plans_->backward.get());
  Vector result(vector.size());
  for (Index j = 0; j < grid_.n_y; ++j)
    for (Index i = 0; i < grid_.n_x; ++i)
      for (Index f = 0; f < n_fields; ++f)
        result[n_fields * (j * grid_.n_x + i) + f] = field[f * area + j * padded_x_ + i];
  return result;
}

template class GridTransform<double>;
template class GridTransform<float>;
} // namespace orthocone
