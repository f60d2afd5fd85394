// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/change_length.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace orthocone
{
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace
{
using Values = std::function<VectorXd(const Vector2d &)>;

/// Norms of the gradients of all values at a place, by central differences.
VectorXd slopes(const Values &values, const Vector2d &place, const double step)
{
  VectorXd squares = VectorXd::Zero(values(place).size());
  for (const Vector2d &way : {Vector2d(step, 0), Vector2d(0, step)})
    squares += ((values(place + way) - values(place - way)) / (2 * step)).cwiseAbs2();
  return squares.cwiseSqrt();
}

void shorten(VectorXd &lengths, const Values &values, const std::vector<Vector2d> &places, const double step)
{
  MatrixXd at_places(values(places.front()).size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    at_places.col(static_cast<Eigen::Index>(i)) = values(places[i]);
  const VectorXd ranges = at_places.rowwise().maxCoeff() - at_places.rowwise().minCoeff();
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const VectorXd slope = slopes(values, places[i], step);
    double &length = lengths[static_cast<Eigen::Index>(i)];
    for (Eigen::Index k = 0; k < slope.size(); ++k)
      if (slope[k] > 0 && std::isfinite(slope[k])) // just outside the surface there may be no value
        length =
            std::min(length, std::max(step, ranges[k] / slope[k])); // all nodes may lie on zeros of a wave
  }
}
} // namespace

VectorXd change_lengths(const Obstacle &obstacle, const FrictionField &friction,
                        const ContactSurface &surface)
{
  constexpr double fine = 1e-4; // step of the differences, relative to the reach of the surface
  const std::vector<Vector2d> places = places_of(surface);
  double reach = 0;
  for (const Vector2d &place : places)
    reach = std::max(reach, place.norm());
  VectorXd lengths =
      VectorXd::Constant(static_cast<Eigen::Index>(places.size()), std::numeric_limits<double>::infinity());
  if (!obstacle.is_plane())
    shorten(
        lengths, [&](const Vector2d &place) { return VectorXd::Constant(1, obstacle.gap(place)).eval(); },
        places, fine * reach);
  if (friction.varies())
    shorten(
        lengths, [&](const Vector2d &place) { return friction.numbers(place); }, places, fine * reach);
  return lengths;
}
} // namespace orthocone
