// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/local_axes.h>

#include <orthocone/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Matrix3d;

namespace
{
Matrix2d turn_by(const double angle)
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
  Matrix2d turn;
  turn << cosine, -sine, sine, cosine;
  return turn;
}
} // namespace

LocalAxes::LocalAxes(const double angle)
    : turns_{turn_by(angle)}
{
}

LocalAxes::LocalAxes(const std::vector<double> &angles)
{
  if (angles.empty())
    throw std::logic_error("local axes need at least one angle");
  const bool is_one = std::adjacent_find(angles.begin(), angles.end(), std::not_equal_to<>()) == angles.end();
  for (std::size_t node = 0; node < (is_one ? 1 : angles.size()); ++node)
    turns_.push_back(turn_by(angles[node]));
}

Matrix3d LocalAxes::global_in_local(const std::size_t node) const
{
  Matrix3d axes = Matrix3d::Zero();
  axes.topRightCorner<2, 2>() = turn(node);
  axes(2, 0) = 1;
  return axes;
}
} // namespace orthocone
