// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "half_space_patches.h"

#include "face_basis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace
{
/// The points of the unit interval where the weights of its nodes meet.
std::vector<double> weight_ends(const unsigned int degree)
{
  switch (degree)
  {
  case 1:
    return {0, 0.5, 1};
  case 2:
    return {0, 1. / 6, 5. / 6, 1};
  default:
    return {0, 1. / 12, 0.5, 11. / 12, 1};
  }
}

/// Quadrature rules. The displacement under a patch has kinks at its edges, so that patches that share an
/// edge need more points.
struct Rules
{
  explicit Rules(const unsigned int n)
      : points(gauss_rule(n)),
        close_points(gauss_rule(2 * n))
  {
  }
  std::vector<std::array<double, 2>> points, close_points;
};

/// A part of a patch in one face: corners anticlockwise.
using Quadrilateral = std::array<Vector2d, 4>;

double cross(const Vector2d &a, const Vector2d &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// Calls use(position, area) at the Gauss points of a quadrilateral.
template<typename Use>
void at_points(const Quadrilateral &corners, const std::vector<std::array<double, 2>> &rule, const Use &use)
{
  for (const auto &[v, weight_v] : rule)
    for (const auto &[u, weight_u] : rule)
    {
      const Vector2d low = (1 - u) * corners[0] + u * corners[1];
      const Vector2d high = (1 - u) * corners[3] + u * corners[2];
      const Vector2d along_u = (1 - v) * (corners[1] - corners[0]) + v * (corners[2] - corners[3]);
      use((1 - v) * low + v * high, weight_u * weight_v * cross(along_u, high - low));
    }
}

/// Adds a part to a patch. Moments are about the origin until finish().
void add_part(SurfacePatch &patch, const Quadrilateral &corners, const Rules &rules)
{
  static const auto exact = gauss_rule(2);
  at_points(corners, exact,
            [&](const Vector2d &position, const double area)
            {
              patch.area += area;
              patch.centre += area * position;
              patch.spread += area * position * position.transpose();
            });
  at_points(corners, rules.points,
            [&](const Vector2d &position, const double area) {
              patch.points.push_back({position, area});
            });
  at_points(corners, rules.close_points,
            [&](const Vector2d &position, const double area) {
              patch.close_points.push_back({position, area});
            });
  for (unsigned int i = 0; i < 4; ++i)
    patch.edges.emplace_back(corners[i], corners[(i + 1) % 4]);
}

bool are_opposite(const PatchEdge &a, const PatchEdge &b)
{
  constexpr double rounding = 1e-9;
  return (a.from - b.to).norm() <= rounding * a.length && (a.to - b.from).norm() <= rounding * a.length;
}

/// Edges between two parts of a patch are not edges of the patch.
void remove_inner_edges(std::vector<PatchEdge> &edges)
{
  std::vector<PatchEdge> outer;
  for (const PatchEdge &edge : edges)
    if (std::none_of(edges.begin(), edges.end(),
                     [&](const PatchEdge &other) { return are_opposite(edge, other); }))
      outer.push_back(edge);
  edges = std::move(outer);
}

void finish(SurfacePatch &patch)
{
  patch.centre /= patch.area;
  patch.spread = patch.spread / patch.area - patch.centre * patch.centre.transpose();
  for (auto *const points : {&patch.points, &patch.close_points})
    for (SurfacePatch::Point &point : *points)
      point.share /= patch.area;
  remove_inner_edges(patch.edges);
  for (const PatchEdge &edge : patch.edges)
    patch.radius = std::max(patch.radius, (edge.from - patch.centre).norm());
}

/// The corners of the parts of a face, (degree + 2)^2, lexicographic.
std::vector<Vector2d> part_corners(const PlaneFace &face, const std::vector<double> &ends)
{
  std::vector<Vector2d> corners;
  for (const double v : ends)
    for (const double u : ends)
      corners.push_back(face.position({u, v}));
  return corners;
}
} // namespace

std::vector<SurfacePatch> surface_patches(const ContactSurface &surface, const WholeSurface &whole,
                                          const unsigned int n_points)
{
  const std::vector<double> ends = weight_ends(surface.degree);
  const Rules rules(n_points);
  const std::size_t n = surface.degree + 1;
  std::vector<SurfacePatch> patches(whole.nodes.size());
  for (const auto &face : whole.faces)
  {
    std::vector<Vector2d> places;
    for (const unsigned int node : face)
    {
      const auto &position = surface.place(whole.nodes[node].node).position;
      places.emplace_back(whole.images[whole.nodes[node].image] * Vector2d(position[0], position[1]));
    }
    const std::vector<Vector2d> corners = part_corners(PlaneFace(surface.degree, places), ends);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
      {
        const std::size_t first = i + (n + 1) * j;
        add_part(patches[face[i + n * j]],
                 {corners[first], corners[first + 1], corners[first + n + 2], corners[first + n + 1]}, rules);
      }
  }
  for (SurfacePatch &patch : patches)
    finish(patch);
  return patches;
}
} // namespace orthocone
