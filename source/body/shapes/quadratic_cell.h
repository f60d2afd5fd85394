// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <utility>

namespace orthocone
{
/// The map of a cell of second order: x(u) = sum over its nodes of N_i(u) x_i, u in [0, 1]^dim, with the
/// products N_i of Lagrange's polynomials of degree 2 in each direction for 0, 1/2 and 1. Nodes are in
/// lexicographic order, the first direction fastest; lengths are in mm.
template<int dim>
class QuadraticCell
{
public:
  static constexpr unsigned int n_nodes = dim == 2 ? 9 : 27;
  using Nodes = std::array<dealii::Point<dim>, n_nodes>;

  explicit QuadraticCell(const Nodes &nodes)
      : nodes_(nodes)
  {
  }

  const Nodes &nodes() const { return nodes_; }

  /// The place of a node in each direction: 0, 1 (the middle) or 2.
  static std::array<unsigned int, dim> places(unsigned int node)
  {
    std::array<unsigned int, dim> all{};
    for (unsigned int &place : all)
    {
      place = node % 3;
      node /= 3;
    }
    return all;
  }

  /// The place of a node in the unit cell.
  static dealii::Point<dim> unit_node(const unsigned int node)
  {
    dealii::Point<dim> unit;
    const auto all = places(node);
    for (unsigned int d = 0; d < dim; ++d)
      unit[d] = all[d] / 2.;
    return unit;
  }

  dealii::Point<dim> value(const dealii::Point<dim> &unit) const
  {
    std::array<std::array<double, 3>, dim> factors;
    for (unsigned int d = 0; d < dim; ++d)
      factors[d] = values_at(unit[d]);
    return combined(factors);
  }

  /// The matrix of the derivatives of x_i with respect to u_j.
  dealii::Tensor<2, dim> jacobian(const dealii::Point<dim> &unit) const
  {
    dealii::Tensor<2, dim> result;
    for (unsigned int j = 0; j < dim; ++j)
    {
      std::array<std::array<double, 3>, dim> factors;
      for (unsigned int d = 0; d < dim; ++d)
        factors[d] = d == j ? slopes_at(unit[d]) : values_at(unit[d]);
      const dealii::Point<dim> slope = combined(factors);
      for (unsigned int i = 0; i < dim; ++i)
        result[i][j] = slope[i];
    }
    return result;
  }

  /// A box that holds the cell: that of its Bezier points, whose convex hull holds it.
  dealii::BoundingBox<dim> box() const
  {
    Nodes points = nodes_;
    for (unsigned int d = 0, stride = 1; d < dim; ++d, stride *= 3)
      for (unsigned int i = 0; i < n_nodes; ++i)
        if (places(i)[d] == 1)
          points[i] += points[i] - (points[i - stride] + (points[i + stride] - points[i - stride]) / 2);
    std::pair<dealii::Point<dim>, dealii::Point<dim>> corners{points[0], points[0]};
    for (const auto &point : points)
      for (unsigned int d = 0; d < dim; ++d)
      {
        corners.first[d] = std::min(corners.first[d], point[d]);
        corners.second[d] = std::max(corners.second[d], point[d]);
      }
    return dealii::BoundingBox<dim>(corners);
  }

private:
  static std::array<double, 3> values_at(const double u)
  {
    return {{(1 - u) * (1 - 2 * u), 4 * u * (1 - u), u * (2 * u - 1)}};
  }
  static std::array<double, 3> slopes_at(const double u) { return {{4 * u - 3, 4 - 8 * u, 4 * u - 1}}; }

  dealii::Point<dim> combined(const std::array<std::array<double, 3>, dim> &factors) const
  {
    dealii::Point<dim> sum;
    for (unsigned int i = 0; i < n_nodes; ++i)
    {
      const auto all = places(i);
      double product = 1;
      for (unsigned int d = 0; d < dim; ++d)
        product *= factors[d][all[d]];
      for (unsigned int d = 0; d < dim; ++d)
        sum[d] += product * nodes_[i][d];
    }
    return sum;
  }

  Nodes nodes_;
};

/// Determinant of the Jacobian / product of the lengths of its columns, the least at 5 points in each
/// direction: 1 for a brick, <= 0 or not a number for a cell that is inverted somewhere. The determinant is a
/// polynomial of degree 5 in each direction.
template<int dim>
double scaled_jacobian(const QuadraticCell<dim> &cell)
{
  constexpr unsigned int n_points = 5;
  double least = 1;
  for (unsigned int point = 0; point < (dim == 2 ? n_points * n_points : n_points * n_points * n_points);
       ++point)
  {
    dealii::Point<dim> unit;
    for (unsigned int d = 0, rest = point; d < dim; ++d, rest /= n_points)
      unit[d] = rest % n_points / (n_points - 1.);
    const dealii::Tensor<2, dim> columns = transpose(cell.jacobian(unit));
    double lengths = 1;
    for (unsigned int d = 0; d < dim; ++d)
      lengths *= columns[d].norm();
    const double here = determinant(columns) / lengths;
    if (!(here > 0))
      return here;
    least = std::min(least, here);
  }
  return least;
}
} // namespace orthocone
