// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <array>
#include <utility>
#include <vector>

namespace orthocone
{
/// Nodes of a face by their lexicographic numbers in the cell, themselves lexicographic: along two axes that
/// make a right-handed system with the normal into the cell.
template<int dim>
std::vector<unsigned int> nodes_of_face(const unsigned int face, const unsigned int degree)
{
  const unsigned int normal = face / 2, n = degree + 1;
  unsigned int first = (normal + 1) % dim, second = dim == 2 ? normal : (normal + 2) % dim;
  if (dim == 3 && face % 2 == 1)
    std::swap(first, second);
  const std::array<unsigned int, 3> stride{{1, n, n * n}};
  std::vector<unsigned int> nodes;
  for (unsigned int j = 0; j < (dim == 2 ? 1 : n); ++j)
    for (unsigned int i = 0; i < n; ++i)
      nodes.push_back((face % 2) * degree * stride[normal] + i * stride[first] + j * stride[second]);
  return nodes;
}
} // namespace orthocone
