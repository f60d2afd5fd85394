// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/tria.h>

namespace orthocone
{
/// The parallelepiped that is nearest to a cell. Its coordinates are those of the unit cell where the cell is
/// a parallelepiped itself, and unlike these they are linear in space in every cell.
template<int dim>
class Parallelepiped
{
public:
  Parallelepiped() = default;
  explicit Parallelepiped(const typename dealii::Triangulation<dim>::cell_iterator &cell)
  {
    dealii::Tensor<2, dim> axes;
    for (const unsigned int i : cell->vertex_indices())
    {
      const dealii::Point<dim> unit = dealii::GeometryInfo<dim>::unit_cell_vertex(i);
      centre_ += cell->vertex(i) / n_vertices;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          axes[d][e] += (unit[e] - 0.5) * 4 / n_vertices * cell->vertex(i)[d];
    }
    to_unit_ = invert(axes);
  }

  /// Coordinates of a place (mm), from 0 to 1 within the parallelepiped.
  dealii::Point<dim> coordinates(const dealii::Point<dim> &place) const
  {
    dealii::Point<dim> unit;
    for (unsigned int d = 0; d < dim; ++d)
      unit[d] = 0.5;
    unit += to_unit_ * (place - centre_);
    return unit;
  }

private:
  static constexpr unsigned int n_vertices = dealii::GeometryInfo<dim>::vertices_per_cell;
  dealii::Point<dim> centre_;
  dealii::Tensor<2, dim> to_unit_; ///< 1/mm
};
} // namespace orthocone
