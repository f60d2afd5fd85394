// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "monomials.h"
#include "point_law.h"

namespace orthocone
{
/// ProjectedDivergence of a displacement, in several cells. With monomials m_k of the coordinates, the
/// projection is sum of c_k m_k with M c = b: moments b_k = sum over points of weight m_k div(u), and the
/// mass matrix M of the cell, whose inverse is stored. So a cell is passed twice: add() at all points,
/// solve(), and at() at all points. This is the element Q_k / P_(k-1) with discontinuous pressures, without
/// the pressures (docs/theory.md, section 2).
template<typename Number>
class Projection
{
public:
  using Values = typename Lanes<Number>::Values;

  ORTHOCONE_INLINE explicit Projection(const unsigned int n_polynomials)
      : n_(n_polynomials)
  {
    for (unsigned int k = 0; k < n_; ++k)
      coefficients_[k] = Values{};
  }

  /// Adds a point to the moments of the divergence.
  ORTHOCONE_INLINE void add(const Lanes<Number> *const geometry, const Lanes<Number> *const gradient,
                            const unsigned int step)
  {
    Values monomials[most_monomials];
    make(geometry, monomials);
    const Values divergence = geometry[9].values * in_space(geometry, gradient, step).trace();
    for (unsigned int k = 0; k < n_; ++k)
      coefficients_[k] += monomials[k] * divergence;
  }

  /// The moments become coefficients.
  ORTHOCONE_INLINE void solve(const Lanes<Number> *const inverse_mass)
  {
    Values moments[most_monomials];
    for (unsigned int k = 0; k < n_; ++k)
      moments[k] = coefficients_[k];
    for (unsigned int k = 0; k < n_; ++k)
    {
      coefficients_[k] = Values{};
      for (unsigned int l = 0; l < n_; ++l)
      {
        const unsigned int row = l < k ? k : l, column = l < k ? l : k;
        coefficients_[k] += inverse_mass[row * (row + 1) / 2 + column].values * moments[l];
      }
    }
  }

  /// The projected divergence at a point.
  ORTHOCONE_INLINE Values at(const Lanes<Number> *const geometry) const
  {
    Values monomials[most_monomials], sum{};
    make(geometry, monomials);
    for (unsigned int k = 0; k < n_; ++k)
      sum += coefficients_[k] * monomials[k];
    return sum;
  }

private:
  ORTHOCONE_INLINE void make(const Lanes<Number> *const geometry, Values *const monomials) const
  {
    Values coordinates[3] = {};
    for (unsigned int d = 0; d < 3 && n_ > 1; ++d)
      coordinates[d] = geometry[10 + d].values;
    make_monomials(coordinates, n_, monomials);
  }

  unsigned int n_;
  Values coefficients_[most_monomials]; ///< of the monomials; moments before solve()
};
} // namespace orthocone
