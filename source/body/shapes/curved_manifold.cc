// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "curved_manifold.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/table.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace orthocone
{
using dealii::ArrayView;
using dealii::Point;

template<int dim>
struct CurvedManifold<dim>::Cells
{
  using Box = dealii::BoundingBox<dim>;

  explicit Cells(std::vector<CurvedCell<dim>> all)
      : cells(std::move(all)),
        boxes(boxes_of(cells)),
        tree(dealii::pack_rtree_of_indices(boxes))
  {
  }
  Cells(const Cells &) = delete;
  Cells &operator=(const Cells &) = delete;

  std::vector<std::size_t> around(const Point<dim> &point) const;

  static std::vector<Box> boxes_of(const std::vector<CurvedCell<dim>> &cells)
  {
    std::vector<Box> boxes;
    for (const CurvedCell<dim> &cell : cells)
      boxes.push_back(cell.box());
    return boxes;
  }

  std::vector<CurvedCell<dim>> cells;
  std::vector<Box> boxes;
  decltype(dealii::pack_rtree_of_indices(std::declval<const std::vector<Box> &>())) tree; ///< of `boxes`
};

template<int dim>
CurvedManifold<dim>::CurvedManifold(std::vector<CurvedCell<dim>> cells)
    : cells_(std::make_shared<const Cells>(std::move(cells)))
{
}

template<int dim>
std::unique_ptr<dealii::Manifold<dim, dim>> CurvedManifold<dim>::clone() const
{
  return std::make_unique<CurvedManifold<dim>>(*this);
}

/// Those whose boxes hold a point, those first in whose middle it is.
template<int dim>
std::vector<std::size_t> CurvedManifold<dim>::Cells::around(const Point<dim> &point) const
{
  namespace bgi = boost::geometry::index;
  std::vector<std::pair<double, std::size_t>> found;
  for (auto cell = tree.qbegin(bgi::intersects(point)); cell != tree.qend(); ++cell)
    found.emplace_back(cells[*cell].distance_from_middle(point), *cell);
  std::sort(found.begin(), found.end());
  std::vector<std::size_t> all;
  for (const auto &[distance, cell] : found)
    all.push_back(cell);
  return all;
}

/// The coarse cell out of which the points stick the least, which is by rounding alone. The box of a cell
/// that holds the points also holds their mean.
template<int dim>
typename CurvedManifold<dim>::Chart
CurvedManifold<dim>::chart_of(const ArrayView<const Point<dim>> &points) const
{
  constexpr double rounding = 1e-9;
  Point<dim> mean;
  for (const Point<dim> &point : points)
    mean += point / static_cast<double>(points.size());
  Chart best{nullptr, {}};
  double least = std::numeric_limits<double>::max();
  std::vector<Point<dim>> units(points.size());
  for (const std::size_t candidate : cells_->around(mean))
  {
    double outside = 0;
    for (std::size_t i = 0; i < points.size() && outside < least; ++i)
    {
      const auto unit = cells_->boxes[candidate].point_inside(points[i])
                            ? cells_->cells[candidate].pull_back(points[i])
                            : std::nullopt;
      units[i] = unit.value_or(Point<dim>());
      outside = std::max(outside, unit ? dealii::GeometryInfo<dim>::distance_to_unit_cell(*unit)
                                       : std::numeric_limits<double>::max());
    }
    if (outside < least)
    {
      least = outside;
      best = {&cells_->cells[candidate], units};
    }
    if (least <= rounding)
      break;
  }
  AssertThrow(best.cell != nullptr, dealii::ExcMessage("no cell of the mesh file holds these points"));
  return best;
}

template<int dim>
Point<dim> CurvedManifold<dim>::get_new_point(const ArrayView<const Point<dim>> &surrounding_points,
                                              const ArrayView<const double> &weights) const
{
  const Chart chart = chart_of(surrounding_points);
  Point<dim> unit;
  for (std::size_t i = 0; i < weights.size(); ++i)
    unit += weights[i] * chart.units[i];
  return chart.cell->push_forward(unit);
}

template<int dim>
void CurvedManifold<dim>::get_new_points(const ArrayView<const Point<dim>> &surrounding_points,
                                         const dealii::Table<2, double> &weights,
                                         ArrayView<Point<dim>> new_points) const
{
  const Chart chart = chart_of(surrounding_points);
  for (std::size_t row = 0; row < weights.size(0); ++row)
  {
    Point<dim> unit;
    for (std::size_t i = 0; i < weights.size(1); ++i)
      unit += weights(row, i) * chart.units[i];
    new_points[row] = chart.cell->push_forward(unit);
  }
}

template class CurvedManifold<2>;
template class CurvedManifold<3>;
} // namespace orthocone
