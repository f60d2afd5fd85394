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

/// A triangle of a polygon that need not be convex: such triangles with their signs are the polygon.
struct SignedTriangle
{
  PlanePolygon corners; ///< three, anticlockwise
  double sign;          ///< 1, or -1 where the triangle takes off what others have too much
};

/// The triangles that the mean of the corners makes with the edges, anticlockwise as a whole. A mirror image
/// has the mirror images of them, so that models and their halves are integrated alike.
std::vector<SignedTriangle> triangles(const PlanePolygon &polygon);

/// What a convex polygon has in common with a triangle, both anticlockwise: convex, or without corners.
///
/// Written for two triangles because Boost.Geometry (1.74) does not serve: with its grid of integers areas
/// have eight digits, and without it edges that nearly coincide made it return a whole face.
PlanePolygon common_part(const PlanePolygon &convex, const PlanePolygon &triangle);
} // namespace orthocone
