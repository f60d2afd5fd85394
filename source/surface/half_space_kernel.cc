// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "half_space_kernel.h"

#include <orthocone/base/numbers.h>

#include <cmath>

namespace orthocone
{
using Eigen::Matrix3d;
using Eigen::Vector2d;

namespace
{
/// Integral of 1 / sqrt(h^2 + s^2) from s_1 to s_2, without cancellation.
double integral_of_reciprocal(const double s_1, const double r_1, const double s_2, const double r_2)
{
  return s_1 + s_2 > 0 ? std::log((s_2 + r_2) / (s_1 + r_1)) : std::log((r_1 - s_1) / (r_2 - s_2));
}
} // namespace

// With h the distance of the edge, s the way along it and R^2 = h^2 + s^2, the integral of f(direction) / R
// over the triangle of point and edge is the integral of f h / R over s.
void HalfSpaceKernel::add_edge(const PatchEdge &edge, const Vector2d &point, const double weight)
{
  constexpr double rounding = 1e-13;
  const Vector2d &tangent = edge.tangent;
  const Vector2d normal(tangent[1], -tangent[0]);
  const Vector2d first = edge.from - point;
  const double h = first.dot(normal);
  const double s_1 = first.dot(tangent), s_2 = s_1 + edge.length;
  if (std::abs(h) <= rounding * (std::abs(s_1) + std::abs(s_2)))
    return; // the edge is in line with the point: the triangle has no area
  const double r_1 = std::sqrt(h * h + s_1 * s_1), r_2 = std::sqrt(h * h + s_2 * s_2);
  const double along = h * integral_of_reciprocal(s_1, r_1, s_2, r_2);
  const double of_sines = h * (s_2 / r_2 - s_1 / r_1);
  const double mixed = -h * h * (1 / r_2 - 1 / r_1);
  const double of_tangent = along - of_sines;
  one += weight * along;
  xx += weight * (normal[0] * normal[0] * of_sines + 2 * normal[0] * tangent[0] * mixed +
                  tangent[0] * tangent[0] * of_tangent);
  xy +=
      weight * (normal[0] * normal[1] * of_sines + (normal[0] * tangent[1] + normal[1] * tangent[0]) * mixed +
                tangent[0] * tangent[1] * of_tangent);
  yy += weight * (normal[1] * normal[1] * of_sines + 2 * normal[1] * tangent[1] * mixed +
                  tangent[1] * tangent[1] * of_tangent);
  // These directions are from the point to the forces.
  const double angle = h * std::atan2(h * (s_2 - s_1), h * h + s_1 * s_2);
  const double logarithm = h * std::log(r_2 / r_1);
  x -= weight * (normal[0] * angle + tangent[0] * logarithm);
  y -= weight * (normal[1] * angle + tangent[1] * logarithm);
}

// Johnson, (3.19) and (3.75), whose z points into the half-space.
Matrix3d HalfSpaceKernel::displacements(const HalfSpace &half_space) const
{
  const double nu = half_space.poisson_ratio;
  const double shear = (1 + nu) / (pi * half_space.young_modulus); // 1 / (2 pi G)
  const double coupling = shear * (1 - 2 * nu) / 2;
  const double even = shear * (1 - nu) * one;
  Matrix3d columns;
  columns << even + shear * nu * xx, shear * nu * xy, coupling * x, //
      shear * nu * xy, even + shear * nu * yy, coupling * y,        //
      -coupling * x, -coupling * y, even;
  return columns;
}
} // namespace orthocone
