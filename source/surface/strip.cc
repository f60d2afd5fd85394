// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/strip.h>

#include "face_basis.h"

#include <vector>

namespace orthocone
{
using Eigen::Index;

namespace
{
/// The map of strips, summed over the nodes of lines: n_across_rows and n_across_columns nodes make one.
Eigen::SparseMatrix<double> of_lines(const Eigen::SparseMatrix<double> &map, const Index n_across_rows,
                                     const Index n_across_columns)
{
  std::vector<Eigen::Triplet<double>> terms;
  for (Index j = 0; j < map.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(map, j); it; ++it)
      terms.emplace_back(it.row() / n_across_rows, j / n_across_columns,
                         it.value() / static_cast<double>(n_across_rows));
  Eigen::SparseMatrix<double> lines(map.rows() / n_across_rows, map.cols() / n_across_columns);
  lines.setFromTriplets(terms.begin(), terms.end());
  return lines;
}
} // namespace

ContactSurface as_faces(const ContactSurface &surface, const ModelSymmetry &symmetry)
{
  if (!symmetry.is_plane_strain())
    return surface;
  const unsigned int n = surface.degree + 1;
  const std::vector<double> &across = face_nodes(surface.degree);
  ContactSurface strip;
  strip.degree = surface.degree;
  for (const ContactNode &line : surface.nodes)
    for (unsigned int j = 0; j < n; ++j)
    {
      strip.nodes.push_back(line);
      strip.nodes.back().position[1] = symmetry.section()->thickness * across[j];
      strip.nodes.back().area = line.area / n;
    }
  for (const auto &line : surface.faces)
  {
    strip.faces.emplace_back();
    for (unsigned int j = 0; j < n; ++j)
      for (const unsigned int node : line)
        strip.faces.back().push_back(node * n + j);
  }
  return strip;
}

MortarMap mortar_map(const ContactSurface &surface, const ContactSurface &other,
                     const ModelSymmetry &symmetry, const Facing facing)
{
  MortarMap mortar = mortar_map(as_faces(surface, symmetry), as_faces(other, symmetry), facing);
  if (symmetry.is_plane_strain() && mortar.cover.is_enough())
    mortar.map = of_lines(mortar.map, surface.degree + 1, other.degree + 1);
  return mortar;
}
} // namespace orthocone
