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
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
using Values = std::function<VectorXd(const SurfacePoint &)>;

/// Norms of the gradients along the surface of all values at a point, by central differences.
VectorXd slopes(const Values &values, const SurfacePoint &point, const double step, const Matrix3d &axes)
{
  VectorXd squares = VectorXd::Zero(values(point).size());
  for (const Vector3d &way : {Vector3d(step * axes.col(1)), Vector3d(step * axes.col(2))})
    squares +=
        ((values({point.place + way, point.inward}) - values({point.place - way, point.inward})) / (2 * step))
            .cwiseAbs2();
  return squares.cwiseSqrt();
}

/// `axes` are those of the points, or uniform. Values that differ by less than `rounding` are the same.
void shorten(VectorXd &lengths, const Values &values, const std::vector<SurfacePoint> &places,
             const double step, const LocalAxes &axes, const double rounding)
{
  MatrixXd at_places(values(places.front()).size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    at_places.col(static_cast<Eigen::Index>(i)) = values(places[i]);
  const VectorXd ranges = at_places.rowwise().maxCoeff() - at_places.rowwise().minCoeff();
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const VectorXd slope = slopes(values, places[i], step, axes.global_in_local(i));
    double &length = lengths[static_cast<Eigen::Index>(i)];
    for (Eigen::Index k = 0; k < slope.size(); ++k)
      if (ranges[k] > rounding && slope[k] > 0 &&
          std::isfinite(slope[k])) // just outside the surface there may be no value
        length =
            std::min(length, std::max(step, ranges[k] / slope[k])); // all nodes may lie on zeros of a wave
  }
}
} // namespace

VectorXd change_lengths(const Obstacle &obstacle, const FrictionField &friction,
                        const ContactSurface &surface, const LocalAxes &axes)
{
  constexpr double fine = 1e-4; // step of the differences, relative to the reach of the surface
  constexpr double rounding = 1e-12;
  const std::vector<SurfacePoint> places = points_of(surface);
  const LocalAxes along = obstacle.has_normal_z() ? LocalAxes(0.) : axes;
  double reach = 0;
  for (const SurfacePoint &point : places)
    reach = std::max(reach, obstacle.has_normal_z() ? point.in_plane().norm() : point.place.norm());
  VectorXd lengths =
      VectorXd::Constant(static_cast<Eigen::Index>(places.size()), std::numeric_limits<double>::infinity());
  if (!obstacle.is_plane())
    shorten(
        lengths,
        [&](const SurfacePoint &point)
        {
          const double height = obstacle.has_normal_z() ? point.place[2] : 0; // no part of the counterface
          return VectorXd::Constant(1, obstacle.gap(point) - height).eval();
        },
        places, fine * reach, along, rounding * reach);
  if (friction.varies())
    shorten(
        lengths, [&](const SurfacePoint &point) { return friction.numbers(point.place); }, places,
        fine * reach, along, 0);
  return lengths;
}
} // namespace orthocone
