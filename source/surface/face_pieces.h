// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <array>
#include <vector>

namespace orthocone
{
/// Corners of a polygon in the plane, mm.
using PlanePolygon = std::vector<Eigen::Vector2d>;

/// Positive where the corners run anticlockwise, mm^2.
double signed_area(const PlanePolygon &polygon);

/// A triangle of a polygon that need not be convex: the sum of such triangles with their signs is the
/// polygon.
struct SignedTriangle
{
  PlanePolygon corners; ///< three, anticlockwise
  double sign;          ///< 1, or -1 where other triangles cover too much
};

/// The triangles between the mean of the corners and the edges of an anticlockwise polygon. A mirror image
/// has the mirror images of these triangles, so that models and their halves are integrated alike.
std::vector<SignedTriangle> triangles(const PlanePolygon &polygon);

/// The intersection of a convex polygon and a triangle, both anticlockwise: it is convex, or has no corners.
///
/// It is written here because Boost.Geometry (1.74) does not serve: with its grid of integers areas have
/// eight digits, and without the grid edges that nearly coincide made it return a whole face.
PlanePolygon common_part(const PlanePolygon &convex, const PlanePolygon &triangle);
} // namespace orthocone
