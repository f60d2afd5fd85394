// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/half_space.h>

#include <cmath>

namespace orthocone
{
/// An edge of a patch, which lies to its left.
struct PatchEdge
{
  PatchEdge(const Eigen::Vector2d &begin, const Eigen::Vector2d &end)
      : from(begin),
        to(end),
        length((end - begin).norm()),
        tangent((end - begin) / length)
  {
  }

  Eigen::Vector2d from, to; ///< mm
  double length;            ///< mm
  Eigen::Vector2d tangent;
};

/// The sums from which the displacement at one point of a half-space follows, for a force, or forces that are
/// spread, at other points (docs/theory.md, section 2). With R the distance and (x, y) / R the direction from
/// the force to the point, these are sums of 1 / R, of x^2 / R^3, x y / R^3 and y^2 / R^3, and of x / R^2 and
/// y / R^2, all in 1/mm for a unit force.
struct HalfSpaceKernel
{
  double one = 0;
  double xx = 0, xy = 0, yy = 0;
  double x = 0, y = 0;

  /// Adds `weight` times a force at a distance (mm): the point less the place of the force.
  void add_point(const double distance_x, const double distance_y, const double weight)
  {
    const double reciprocal = 1 / std::sqrt(distance_x * distance_x + distance_y * distance_y);
    const double direction_x = distance_x * reciprocal, direction_y = distance_y * reciprocal;
    const double share = weight * reciprocal;
    one += share;
    xx += share * direction_x * direction_x;
    xy += share * direction_x * direction_y;
    yy += share * direction_y * direction_y;
    x += share * direction_x;
    y += share * direction_y;
  }

  /// Adds one edge's share of forces that are spread evenly, 1 per mm^2, over the domain within the edges;
  /// the point may be anywhere. In polar coordinates about the point the area integrals have no singularity,
  /// and the integrals along the edges that are left have closed forms (after A. E. H. Love, Phil. Trans. R.
  /// Soc. A 228, 1929).
  void add_edge(const PatchEdge &edge, const Eigen::Vector2d &point, double weight);

  /// The kernel with the places of displacement and force exchanged.
  HalfSpaceKernel reversed() const { return {one, xx, xy, yy, -x, -y}; }

  /// The mean of both kernels.
  HalfSpaceKernel mean_with(const HalfSpaceKernel &other) const
  {
    return {(one + other.one) / 2, (xx + other.xx) / 2, (xy + other.xy) / 2,
            (yy + other.yy) / 2,   (x + other.x) / 2,   (y + other.y) / 2};
  }

  /// Displacements x, y, z (mm) by unit forces along x, y, z, which are the columns; z points up, out of the
  /// half-space.
  Eigen::Matrix3d displacements(const HalfSpace &half_space) const;
};
} // namespace orthocone
