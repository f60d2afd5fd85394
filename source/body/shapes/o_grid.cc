// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "o_grid.h"

#include <orthocone/base/grading.h>
#include <orthocone/base/numbers.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace orthocone
{
namespace
{
using dealii::CellData;
using dealii::Point;

/// Numbers of vertices and cells of the whole disc: the core block has (n + 1)^2 vertices, and every ring
/// adds one vertex for each of the 4 n places on the core's perimeter.
class OGrid
{
public:
  OGrid(const double radius, const MeshOptions &options)
      : n_(options.core_cells),
        n_rings_(options.n_rings()),
        radius_(radius),
        half_side_(core_half_side(radius, options.core_ratio)),
        depth_(graded_positions(n_rings_, options.rim_grading))
  {
    for (unsigned int j = 0; j <= n_; ++j)
      for (unsigned int i = 0; i <= n_; ++i)
        vertices.push_back(core_point(i, j));
    for (unsigned int ring = 1; ring <= n_rings_; ++ring)
      for (unsigned int place = 0; place < 4 * n_; ++place)
        vertices.push_back(ring_point(place, ring));
    make_cells();
  }

  std::vector<Point<2>> vertices;
  std::vector<CellData<2>> cells;

private:
  Point<2> core_point(const unsigned int i, const unsigned int j) const
  {
    return {half_side_ * (2. * i / n_ - 1), half_side_ * (2. * j / n_ - 1)};
  }

  /// Core vertex at a place on the perimeter, counted anticlockwise from the corner at -45 degrees.
  unsigned int core_vertex(const unsigned int place) const
  {
    const unsigned int along = place % n_;
    const auto number = [this](const unsigned int i, const unsigned int j) { return j * (n_ + 1) + i; };
    switch (place / n_)
    {
    case 0:
      return number(n_, along);
    case 1:
      return number(n_ - along, n_);
    case 2:
      return number(0, n_ - along);
    default:
      return number(along, 0);
    }
  }

  Point<2> ring_point(const unsigned int place, const unsigned int ring) const
  {
    const double angle = pi / 4 * (2. * place / n_ - 1);
    Point<2> rim(radius_ * std::cos(angle), radius_ * std::sin(angle));
    for (unsigned int d = 0; d < 2; ++d)
      if (std::abs(rim[d]) < 1e-14 * radius_)
        rim[d] = 0; // exactly on the symmetry plane
    const Point<2> &core = vertices[core_vertex(place)];
    return ring == n_rings_ ? rim : core + depth_[ring] * (rim - core);
  }

  unsigned int ring_vertex(const unsigned int place, const unsigned int ring) const
  {
    const unsigned int around = place % (4 * n_);
    return ring == 0 ? core_vertex(around) : (n_ + 1) * (n_ + 1) + (ring - 1) * 4 * n_ + around;
  }

  void add_cell(const std::array<unsigned int, 4> &corners)
  {
    cells.emplace_back();
    cells.back().vertices.assign(corners.begin(), corners.end());
  }

  void make_cells()
  {
    for (unsigned int j = 0; j < n_; ++j)
      for (unsigned int i = 0; i < n_; ++i)
      {
        const unsigned int first = j * (n_ + 1) + i;
        add_cell({{first, first + 1, first + n_ + 1, first + n_ + 2}});
      }
    for (unsigned int ring = 0; ring < n_rings_; ++ring)
      for (unsigned int place = 0; place < 4 * n_; ++place)
        add_cell({{ring_vertex(place, ring), ring_vertex(place, ring + 1), ring_vertex(place + 1, ring),
                   ring_vertex(place + 1, ring + 1)}});
  }

  unsigned int n_;
  unsigned int n_rings_;
  double radius_;
  double half_side_;
  std::vector<double> depth_;
};

bool is_modelled(const CellData<2> &cell, const std::vector<Point<2>> &vertices, const SymmetryPlanes &planes)
{
  Point<2> sum;
  for (const unsigned int vertex : cell.vertices)
    sum += vertices[vertex];
  return (!planes.normal_to_x || sum[0] > 0) && (!planes.normal_to_y || sum[1] > 0);
}
} // namespace

double core_half_side(const double radius, const double core_ratio)
{
  return core_ratio * radius / std::sqrt(2.);
}

void make_o_grid_disc(const double radius, const MeshOptions &options, const SymmetryPlanes &planes,
                      dealii::Triangulation<2> &triangulation)
{
  OGrid grid(radius, options);
  std::vector<CellData<2>> cells;
  for (const auto &cell : grid.cells)
    if (is_modelled(cell, grid.vertices, planes))
      cells.push_back(cell);
  dealii::SubCellData no_subcells;
  dealii::GridTools::delete_unused_vertices(grid.vertices, cells, no_subcells);
  dealii::GridTools::consistently_order_cells(cells);
  triangulation.create_triangulation(grid.vertices, cells, no_subcells);
}
} // namespace orthocone
