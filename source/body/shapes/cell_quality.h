// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_accessor.h>

#include <algorithm>
#include <array>
#include <vector>

namespace orthocone
{
/// Volume of the parallelepiped that the edges at a corner of a hexahedron span / product of their lengths,
/// the least of all corners: 1 for a brick, <= 0 or not a number for a cell that is inverted somewhere.
template<typename Cell>
double scaled_jacobian(const Cell &cell)
{
  double least = 1;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    dealii::Tensor<2, 3> edges;
    double lengths = 1;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const unsigned int low = corner & ~(1U << d);
      edges[d] = cell->vertex(low | (1U << d)) - cell->vertex(low);
      lengths *= edges[d].norm();
    }
    const double here = determinant(edges) / lengths;
    if (!(here > 0))
      return here;
    least = std::min(least, here);
  }
  return least;
}

/// Half the vector product of the diagonals of a quadrilateral, mm^2: its area and normal; for a warped one
/// the vector area of its rim.
template<typename Face>
dealii::Tensor<1, 3> area_vector(const Face &face)
{
  return cross_product_3d(face->vertex(3) - face->vertex(0), face->vertex(2) - face->vertex(1)) / 2;
}

/// The same of a face by its nodes: its corners alone, or with them the middles of its lines and its own, in
/// deal.II's order. Then it is that of each of the four quadrilaterals between them.
inline std::vector<dealii::Tensor<1, 3>> area_vectors(const std::vector<dealii::Point<3>> &nodes)
{
  const auto of = [&](const std::array<unsigned int, 4> &corners)
  {
    return cross_product_3d(nodes[corners[3]] - nodes[corners[0]], nodes[corners[2]] - nodes[corners[1]]) / 2;
  };
  if (nodes.size() == 4)
    return {of({{0, 1, 2, 3}})};
  return {of({{0, 6, 4, 8}}), of({{6, 1, 8, 5}}), of({{4, 8, 2, 7}}), of({{8, 5, 7, 3}})};
}

/// Number of pieces without a common face that the cells form.
inline unsigned int n_pieces(const dealii::Triangulation<3> &triangulation)
{
  std::vector<bool> is_reached(triangulation.n_active_cells(), false);
  unsigned int n = 0;
  for (const auto &start : triangulation.active_cell_iterators())
  {
    if (is_reached[start->active_cell_index()])
      continue;
    ++n;
    std::vector<dealii::Triangulation<3>::cell_iterator> border{start};
    is_reached[start->active_cell_index()] = true;
    while (!border.empty())
    {
      const auto cell = border.back();
      border.pop_back();
      for (const unsigned int face : cell->face_indices())
        if (!cell->at_boundary(face) && !is_reached[cell->neighbor(face)->active_cell_index()])
        {
          border.push_back(cell->neighbor(face));
          is_reached[border.back()->active_cell_index()] = true;
        }
    }
  }
  return n;
}
} // namespace orthocone
