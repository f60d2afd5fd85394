// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/every_processor.h>

namespace orthocone
{
constexpr unsigned int most_monomials = 20; // of degree 3, for displacements of degree 4

/// The first n monomials of three coordinates, by degree: 1, x, y, z, xx, xy, ... Here n is the number of
/// all of some degree and below: 1, 4, 10 or 20. A value may be a number for each of several cells.
/// Those of a degree are x times all of the degree before, y times those of these without x, and z times the
/// last one: one product each, and none twice.
template<typename Value>
ORTHOCONE_INLINE void make_monomials(const Value *const coordinates, const unsigned int n,
                                     Value *const monomials)
{
  monomials[0] = Value{} + 1;
  unsigned int begin = 0, end = 1; // of those of the degree before
#pragma GCC unroll 3
  for (unsigned int degree = 1; end < n; ++degree)
  {
    unsigned int next = end;
#pragma GCC unroll 6
    for (unsigned int i = begin; i < end; ++i)
      monomials[next++] = coordinates[0] * monomials[i];
#pragma GCC unroll 3
    for (unsigned int i = end - degree; i < end; ++i) // those without x
      monomials[next++] = coordinates[1] * monomials[i];
    monomials[next++] = coordinates[2] * monomials[end - 1];
    begin = end;
    end = next;
  }
}
} // namespace orthocone
