// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "face_basis.h"

#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

const std::vector<double> &face_nodes(const unsigned int degree)
{
  static const double third = 0.5 - std::sqrt(1. / 5) / 2;
  static const std::array<std::vector<double>, 3> nodes{{{0, 1}, {0, 0.5, 1}, {0, third, 1 - third, 1}}};
  if (degree < 1 || degree > nodes.size())
    throw std::logic_error("faces have degree 1 to 3");
  return nodes[degree - 1];
}

namespace
{
/// Values and slopes of the Lagrange polynomials of all nodes of a line, at a point.
template<std::size_t n>
struct LineBasis
{
  LineBasis(const std::vector<double> &nodes, const double at)
  {
    for (std::size_t own = 0; own < n; ++own)
    {
      value[own] = 1;
      slope[own] = 0;
      for (std::size_t i = 0; i < n; ++i)
        if (i != own)
        {
          const double scale = 1 / (nodes[own] - nodes[i]);
          slope[own] = (slope[own] * (at - nodes[i]) + value[own]) * scale;
          value[own] *= (at - nodes[i]) * scale;
        }
    }
  }
  std::array<double, n> value{}, slope{};
};

/// Calls use(n) with n as a constant, 2 to 4 nodes of a line: loops of known length take half of the time.
template<typename Use>
auto with_constant(const std::size_t n, const Use &use)
{
  switch (n)
  {
  case 2:
    return use(std::integral_constant<std::size_t, 2>());
  case 3:
    return use(std::integral_constant<std::size_t, 3>());
  default:
    return use(std::integral_constant<std::size_t, 4>());
  }
}

/// What a position lacks at a point of the unit square, and the gradient of the position there.
template<std::size_t n>
std::pair<Vector2d, Matrix2d> linearized(const std::vector<double> &nodes,
                                         const std::vector<Vector2d> &places, const Vector2d &position,
                                         const Vector2d &unit)
{
  const LineBasis<n> u(nodes, unit[0]), v(nodes, unit[1]);
  Vector2d missing = position;
  Matrix2d gradient = Matrix2d::Zero();
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i)
    {
      const Vector2d &place = places[i + n * j];
      missing -= u.value[i] * v.value[j] * place;
      gradient.col(0) += u.slope[i] * v.value[j] * place;
      gradient.col(1) += u.value[i] * v.slope[j] * place;
    }
  return {missing, gradient};
}
} // namespace

std::vector<std::array<double, 2>> gauss_rule(const unsigned int n)
{
  Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 1; i < n; ++i)
    jacobi(i, i - 1) = jacobi(i - 1, i) =
        static_cast<double>(i) / std::sqrt(4 * static_cast<double>(i * i) - 1);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi); // Golub and Welsch
  std::vector<std::array<double, 2>> rule;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    // The points of a pair must be mirror images to the last bit, so that a half of a model is, too.
    const double point = (solver.eigenvalues()[i] - solver.eigenvalues()[n - 1 - i]) / 2;
    const double weight = std::pow(solver.eigenvectors()(0, i), 2);
    const double partner = std::pow(solver.eigenvectors()(0, n - 1 - i), 2);
    rule.push_back({{(1 + point) / 2, (weight + partner) / 2}});
  }
  return rule;
}

PlaneFace::PlaneFace(const unsigned int degree, std::vector<Vector2d> places)
    : nodes_(face_nodes(degree)),
      places_(std::move(places))
{
}

PlaneFace::Values PlaneFace::values(const Vector2d &unit) const
{
  return with_constant(nodes_.size(),
                       [&](const auto n)
                       {
                         const LineBasis<n> u(nodes_, unit[0]), v(nodes_, unit[1]);
                         Values values(n * n);
                         for (std::size_t j = 0; j < n; ++j)
                           for (std::size_t i = 0; i < n; ++i)
                             values[static_cast<Eigen::Index>(i + n * j)] = u.value[i] * v.value[j];
                         return values;
                       });
}

Vector2d PlaneFace::position(const Vector2d &unit) const
{
  const Values at = values(unit);
  Vector2d position = Vector2d::Zero();
  for (std::size_t i = 0; i < places_.size(); ++i)
    position += at[static_cast<Eigen::Index>(i)] * places_[i];
  return position;
}

Vector2d PlaneFace::gradient(const Eigen::VectorXd &field, const Vector2d &unit) const
{
  std::vector<Vector2d> of_field; // as places of which one coordinate is the field
  for (const double value : field)
    of_field.emplace_back(value, 0);
  return with_constant(nodes_.size(),
                       [&](const auto n) -> Vector2d
                       {
                         const Matrix2d of_place = linearized<n>(nodes_, places_, {0, 0}, unit).second,
                                        slopes = linearized<n>(nodes_, of_field, {0, 0}, unit).second;
                         return of_place.transpose().inverse() * slopes.row(0).transpose();
                       });
}

Vector2d PlaneFace::unit_of(const Vector2d &position, const Vector2d &guess) const
{
  constexpr unsigned int most_iterations = 30; // of Newton's method, which takes 2 to 5
  constexpr double settled = 1e-10;            // the next change would be the square of this
  Vector2d unit = guess;
  for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
  {
    const auto [missing, gradient] = with_constant(
        nodes_.size(), [&](const auto n) { return linearized<n>(nodes_, places_, position, unit); });
    const Vector2d change = gradient.inverse() * missing;
    unit += change;
    if (change.lpNorm<Eigen::Infinity>() <= settled)
      break;
  }
  return unit;
}

namespace
{
/// A point of an edge, anticlockwise in the unit square: its share of the way from the first corner.
Vector2d on_edge(const unsigned int edge, const double share)
{
  switch (edge)
  {
  case 0:
    return {share, 0};
  case 1:
    return {1, share};
  case 2:
    return {1 - share, 1};
  default:
    return {0, 1 - share};
  }
}
} // namespace

bool PlaneFace::is_straight(const unsigned int edge, const bool is_projected) const
{
  constexpr double rounding = 1e-12;
  const Vector2d first = position(on_edge(edge, 0)), last = position(on_edge(edge, 1)), way = last - first;
  for (const double node : nodes_)
  {
    Vector2d off = position(on_edge(edge, node)) - first - node * way;
    if (is_projected)
      off -= off.dot(way) / way.squaredNorm() * way;
    if (off.norm() > rounding * way.norm())
      return false;
  }
  return true;
}

std::vector<Vector2d> PlaneFace::outline(const bool is_projected) const
{
  constexpr unsigned int n_pieces = 4; // a 16th of the sagitta is left
  constexpr unsigned int n_edges = 4;
  std::vector<Vector2d> corners;
  for (unsigned int edge = 0; edge < n_edges; ++edge)
    for (unsigned int i = 0, n = is_straight(edge, is_projected) ? 1 : n_pieces; i < n; ++i)
      corners.push_back(position(on_edge(edge, static_cast<double>(i) / n)));
  return corners;
}
} // namespace orthocone
