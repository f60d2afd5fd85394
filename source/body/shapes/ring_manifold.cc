// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "ring_manifold.h"

#include <orthocone/base/numbers.h>

#include <cmath>

namespace orthocone
{
namespace
{
using dealii::Point;

constexpr double eighth_turn = pi / 4;
} // namespace

RingManifold::RingManifold(const double radius, const double half_side, const unsigned int block)
    : radius_(radius),
      half_side_(half_side),
      block_(block)
{
}

std::unique_ptr<dealii::Manifold<3, 3>> RingManifold::clone() const
{
  return std::make_unique<RingManifold>(*this);
}

Point<3> RingManifold::turned(const Point<3> &point, const unsigned int n_quarters)
{
  switch (n_quarters % 4)
  {
  case 0:
    return point;
  case 1:
    return {-point[1], point[0], point[2]};
  case 2:
    return {-point[0], -point[1], point[2]};
  default:
    return {point[1], -point[0], point[2]};
  }
}

Point<3> RingManifold::push_forward(const Point<3> &chart) const
{
  const double angle = eighth_turn * chart[1];
  const double core_y = half_side_ * chart[1];
  const Point<3> in_block(half_side_ + chart[0] * (radius_ * std::cos(angle) - half_side_),
                          core_y + chart[0] * (radius_ * std::sin(angle) - core_y), chart[2]);
  return turned(in_block, block_);
}

/// For a given t, x gives s, and y is a rising function of t: Newton's method finds t.
Point<3> RingManifold::pull_back(const Point<3> &point) const
{
  constexpr unsigned int most_steps = 30; // of Newton's method
  constexpr double settled = 1e-15;
  const Point<3> in_block = turned(point, 4 - block_);
  double t = std::atan2(in_block[1], in_block[0]) / eighth_turn;
  double s = 0;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    const double cosine = std::cos(eighth_turn * t);
    const double sine = std::sin(eighth_turn * t);
    const double depth = radius_ * cosine - half_side_;
    s = (in_block[0] - half_side_) / depth;
    const double bulge = radius_ * sine - half_side_ * t;
    const double s_slope = s * radius_ * eighth_turn * sine / depth;
    const double error = half_side_ * t + s * bulge - in_block[1];
    const double slope = half_side_ + s_slope * bulge + s * (radius_ * eighth_turn * cosine - half_side_);
    t -= error / slope;
    if (std::abs(error) < settled * radius_)
      break;
  }
  return {s, t, in_block[2]};
}
} // namespace orthocone
