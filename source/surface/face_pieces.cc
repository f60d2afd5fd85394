// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "face_pieces.h"

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Vector2d;

double signed_area(const PlanePolygon &polygon)
{
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    const Vector2d a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

std::vector<SignedTriangle> triangles(const PlanePolygon &polygon)
{
  Vector2d centre = Vector2d::Zero();
  for (const Vector2d &corner : polygon)
    centre += corner / static_cast<double>(polygon.size());
  const bool is_anticlockwise = signed_area(polygon) > 0;
  std::vector<SignedTriangle> parts;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    PlanePolygon corners{centre, polygon[i], polygon[(i + 1) % polygon.size()]};
    const bool is_turned = signed_area(corners) < 0;
    if (is_turned)
      std::swap(corners[1], corners[2]);
    parts.push_back({std::move(corners), is_turned == is_anticlockwise ? -1. : 1.});
  }
  return parts;
}

namespace
{
/// Positive to the left of the line from a to b.
double side(const Vector2d &a, const Vector2d &b, const Vector2d &point)
{
  return (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
}

/// The part to the left of the line (Sutherland and Hodgman, Commun. ACM 17, 1974).
PlanePolygon left_of(const Vector2d &a, const Vector2d &b, const PlanePolygon &convex)
{
  PlanePolygon left;
  for (std::size_t i = 0; i < convex.size(); ++i)
  {
    const Vector2d &from = convex[i], &to = convex[(i + 1) % convex.size()];
    const double at_from = side(a, b, from), at_to = side(a, b, to);
    if (at_from >= 0)
      left.push_back(from);
    if ((at_from > 0 && at_to < 0) || (at_from < 0 && at_to > 0))
      left.push_back(from + at_from / (at_from - at_to) * (to - from));
  }
  return left;
}
} // namespace

PlanePolygon common_part(const PlanePolygon &convex, const PlanePolygon &triangle)
{
  PlanePolygon part = convex;
  for (std::size_t i = 0; i < triangle.size() && !part.empty(); ++i)
    part = left_of(triangle[i], triangle[(i + 1) % triangle.size()], part);
  return part;
}
} // namespace orthocone
