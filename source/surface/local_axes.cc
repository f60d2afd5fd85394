// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/local_axes.h>

#include <orthocone/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

namespace orthocone
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d axes_about_z(const double angle)
{
  constexpr double right_angle = 90;
  const double quarters = angle / right_angle;
  double cosine = std::cos(angle * radians_per_degree);
  double sine = std::sin(angle * radians_per_degree);
  if (quarters == std::round(quarters))
  {
    cosine = std::round(cosine);
    sine = std::round(sine);
  }
  Matrix3d axes;
  axes << 0, cosine, -sine, 0, sine, cosine, 1, 0, 0;
  return axes;
}

Matrix3d axes_along(const Vector3d &normal, const Vector3d &along)
{
  constexpr double least = 1e-6;                       // sine of the angle between both
  const Vector3d direction = along.stableNormalized(); // also of a length that has no square
  const Vector3d first = direction - direction.dot(normal) * normal;
  if (!(first.norm() > least))
    throw std::domain_error("a direction along the normal has no projection on the tangent plane");
  Matrix3d axes;
  axes.col(0) = normal;
  axes.col(1) = first.normalized();
  axes.col(2) = normal.cross(axes.col(1));
  return axes;
}

LocalAxes::LocalAxes(const double angle)
    : frames_{axes_about_z(angle)}
{
}

LocalAxes::LocalAxes(const std::vector<double> &angles)
{
  if (angles.empty())
    throw std::logic_error("local axes need at least one angle");
  const bool is_one = std::adjacent_find(angles.begin(), angles.end(), std::not_equal_to<>()) == angles.end();
  for (std::size_t node = 0; node < (is_one ? 1 : angles.size()); ++node)
    frames_.push_back(axes_about_z(angles[node]));
}

LocalAxes::LocalAxes(std::vector<Matrix3d> frames)
    : frames_(std::move(frames))
{
  if (frames_.empty())
    throw std::logic_error("local axes need at least one node");
  if (std::adjacent_find(frames_.begin(), frames_.end(), std::not_equal_to<>()) == frames_.end())
    frames_.resize(1);
}
} // namespace orthocone
