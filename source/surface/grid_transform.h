// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/grid_half_space.h>

#include <functional>
#include <memory>
#include <vector>

namespace orthocone
{
/// The symbol of a compliance at one frequency, in local axes (normal, x, y). Entries between the normal and
/// the tangential directions are odd in space, and therefore imaginary.
template<typename Real>
struct GridSymbol
{
  Real nn = 0, xx = 0, xy = 0, yy = 0;
  Real nx = 0, ny = 0; ///< i times these at (n, x) and (n, y), and -i times at (x, n) and (y, n)
};

template<typename Real>
using GridSymbols = std::vector<GridSymbol<Real>>; ///< of all frequencies

/// Fourier transforms (FFTW) of three fields on a grid that is padded with zeros to twice its size, unless it
/// is periodic, so that products with symbols are convolutions without images. Rows are transformed, then
/// columns: rows that are nothing but padding need no transform of their own. Plans are the same in every
/// run, and each row and column belongs to one thread, so that results are the same to the last bit, whatever
/// the number of threads. `Real` is double or float.
template<typename Real>
class GridTransform
{
public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Kernel = std::function<Eigen::Matrix3d(Eigen::Index, Eigen::Index)>;

  /// With so many threads, or with one where the grid is small.
  GridTransform(const SurfaceGrid &grid, unsigned int n_threads);
  ~GridTransform();
  GridTransform(const GridTransform &) = delete;
  GridTransform &operator=(const GridTransform &) = delete;

  /// The symbols of a kernel, of which `block_at` gives the block at a distance in whole patches, from 0 on.
  GridSymbols<double> symbols(const Kernel &block_at) const;

  /// The symbols that a function gives for the wave numbers along x and y, 1/mm.
  template<typename Function>
  GridSymbols<double> symbols_at(const Function &symbol) const
  {
    GridSymbols<double> symbols;
    for (Eigen::Index q = 0; q < padded_y_; ++q)
      for (Eigen::Index p = 0; p < n_frequencies_; ++p)
        symbols.push_back(symbol(wave_numbers(p, q)));
    return symbols;
  }

  /// The kernel of which these are the symbols: the six values at all distances of a periodic grid.
  GridSymbols<double> kernel(const GridSymbols<double> &symbols) const;

  /// Those of the longest waves, 1/mm.
  Eigen::Vector2d least_wave_numbers() const { return {wave_numbers(1, 0)[0], wave_numbers(0, 1)[1]}; }

  /// The convolution of a vector with three numbers a node.
  Vector product(const GridSymbols<Real> &symbols, const Vector &vector) const;

private:
  struct Plans;
  Eigen::Vector2d wave_numbers(Eigen::Index p, Eigen::Index q) const;
  void transform_row(const Vector &vector, Eigen::Index y) const;
  void multiply(const GridSymbol<Real> *symbols, Eigen::Index q, Eigen::Index first, Eigen::Index last) const;
  void convolve_columns(const GridSymbols<Real> &symbols, Eigen::Index block) const;
  void transform_row_back(Eigen::Index y, Vector &result) const;

  SurfaceGrid grid_;
  Eigen::Index padded_x_, padded_y_, n_frequencies_; ///< these along x
  unsigned int n_threads_;
  std::unique_ptr<Plans> plans_;
};

extern template class GridTransform<double>;
extern template class GridTransform<float>;
} // namespace orthocone
