// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "curved_cell.h"

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthocone
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/// 1 on this side of the unit cell and 0 on the other.
double weight_of(const unsigned int side, const double u)
{
  return side == 0 ? 1 - u : u;
}

/// Moves what rounding leaves beside a face of the unit cell onto it, so that points of a plane stay in it.
template<int dim>
Point<dim> settled(Point<dim> unit)
{
  constexpr double rounding = 1e-12;
  for (unsigned int d = 0; d < dim; ++d)
    for (const double face : {0., 1.})
      if (std::abs(unit[d] - face) < rounding)
        unit[d] = face;
  return unit;
}
} // namespace

template<int dim>
CurvedCell<dim>::CurvedCell(const typename QuadraticCell<dim>::Nodes &nodes, std::vector<Edge> edges,
                            std::vector<Face> faces)
    : quadratic_(nodes),
      edges_(std::move(edges)),
      faces_(std::move(faces))
{
  const dealii::BoundingBox<dim> box = quadratic_.box();
  size_ = box.get_boundary_points().first.distance(box.get_boundary_points().second);
}

template<int dim>
Tensor<1, dim> CurvedCell<dim>::correction(const Edge &edge, Point<dim> unit) const
{
  double weight = 1;
  for (unsigned int d = 0; d < dim; ++d)
    if (d != edge.direction)
    {
      weight *= weight_of(edge.sides[d], unit[d]);
      unit[d] = edge.sides[d];
    }
  if (weight == 0)
    return {};
  const Point<dim> chord = quadratic_.value(unit);
  return weight * (projected(edge.forms, chord) - chord);
}

template<int dim>
Tensor<1, dim> CurvedCell<dim>::correction(const Face &face, Point<dim> unit) const
{
  const double weight = weight_of(face.side, unit[face.direction]);
  if (weight == 0)
    return {};
  unit[face.direction] = face.side;
  Point<dim> base = quadratic_.value(unit);
  for (const Edge &edge : edges_)
    base += correction(edge, unit);
  if constexpr (dim == 3)
    return weight * (face.form.project(base) - base);
  return {};
}

template<int dim>
Point<dim> CurvedCell<dim>::push_forward(const Point<dim> &unit) const
{
  Point<dim> place = quadratic_.value(unit);
  for (const Edge &edge : edges_)
    place += correction(edge, unit);
  for (const Face &face : faces_)
    place += correction(face, unit);
  return place;
}

/// Newton's method with the Jacobian of Q alone, whose error is small as that of Q is. It begins at the
/// nearest node, because the corners of coarse cells and of cells halved once are nodes, and then at the
/// middle.
template<int dim>
std::optional<Point<dim>> CurvedCell<dim>::pull_back(const Point<dim> &place) const
{
  const auto &nodes = quadratic_.nodes();
  const auto nearest = std::min_element(nodes.begin(), nodes.end(),
                                        [&](const Point<dim> &a, const Point<dim> &b)
                                        { return a.distance_square(place) < b.distance_square(place); });
  const auto node = static_cast<unsigned int>(nearest - nodes.begin());
  if (const auto unit = solve(place, QuadraticCell<dim>::unit_node(node)))
    return unit;
  return solve(place, QuadraticCell<dim>::unit_node(QuadraticCell<dim>::n_nodes / 2));
}

template<int dim>
std::optional<Point<dim>> CurvedCell<dim>::solve(const Point<dim> &place, Point<dim> unit) const
{
  constexpr unsigned int most_steps = 60;
  constexpr double rounding = 4e-16, good = 1e-12, far = 1; // of the cell
  double last = 0;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    const Tensor<1, dim> missing = place - push_forward(unit);
    const double error = missing.norm() / size_;
    if (error <= rounding || (error <= good && step > 0 && error > last / 2))
      return settled(unit);
    last = error;
    const Tensor<2, dim> jacobian = quadratic_.jacobian(unit);
    if (!(std::abs(determinant(jacobian)) > 0))
      return std::nullopt;
    unit += invert(jacobian) * missing;
    if (!(dealii::GeometryInfo<dim>::distance_to_unit_cell(unit) < far))
      return std::nullopt;
  }
  return last <= good ? std::make_optional(settled(unit)) : std::nullopt;
}

/// Corrections are far smaller than the cell, and a tenth of it is more than enough for them.
template<int dim>
dealii::BoundingBox<dim> CurvedCell<dim>::box() const
{
  constexpr double rounding = 1e-6, correction = 0.1;
  dealii::BoundingBox<dim> box = quadratic_.box();
  box.extend((edges_.empty() ? rounding : correction) * size_);
  return box;
}

template class CurvedCell<2>;
template class CurvedCell<3>;
} // namespace orthocone
