// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "half_space_patches.h"

#include "face_basis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

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

/// Area and centre of gravity of a part.
struct PatchPart
{
  explicit PatchPart(const Quadrilateral &quadrilateral)
      : corners(quadrilateral)
  {
    static const auto exact = gauss_rule(2);
    at_points(corners, exact,
              [&](const Vector2d &position, const double weight)
              {
                area += weight;
                centre += weight * position;
              });
    centre /= area;
  }

  Quadrilateral corners;
  double area = 0;                    ///< mm^2
  Vector2d centre = Vector2d::Zero(); ///< mm
};

/// Where the force of a place is to have its centre, if shares of the area have it at `centre`. On a mesh
/// that is graded smoothly the place is next to it, by a distance of second order, and a uniform pressure is
/// uniform with these shares. Where sizes jump the distance is of first order, and the force is to be at the
/// place. In between there is a mean of both: a ratio of 1.5 of two neighbours is smooth, one of 2 a jump.
Vector2d centre_wanted(const Vector2d &place, const Vector2d &centre, const double area)
{
  constexpr double smooth = 0.1, jump = 0.15; // of the side of a square
  const double off = (place - centre).norm() / std::sqrt(area);
  return centre + std::clamp((off - smooth) / (jump - smooth), 0., 1.) * (place - centre);
}

/// Shares of a force, and moments of its parts about a place, in units of the side of a square.
struct Shares
{
  std::vector<double> of_parts;
  Vector2d centre = Vector2d::Zero();
  Matrix2d spread = Matrix2d::Zero(); ///< about the centre
};

/// Shares a exp(slope . distance) / sum of parts with areas a.
Shares exponential_shares(const std::vector<PatchPart> &parts, const Vector2d &place, const double area,
                          const Vector2d &slope)
{
  Shares shares;
  double sum = 0;
  for (const PatchPart &part : parts)
  {
    const Vector2d distance = (part.centre - place) / std::sqrt(area);
    const double share = part.area / area * std::exp(slope.dot(distance));
    shares.of_parts.push_back(share);
    sum += share;
    shares.centre += share * distance;
    shares.spread += share * distance * distance.transpose();
  }
  for (double &share : shares.of_parts)
    share /= sum;
  shares.centre /= sum;
  shares.spread = shares.spread / sum - shares.centre * shares.centre.transpose();
  return shares;
}

/// Newton's change of the slope, with the distance of the centre that it moves. Nothing where the parts are
/// in a line and the place is well beside it.
std::optional<std::pair<Vector2d, double>> change_of_slope(const Shares &shares)
{
  constexpr double flat = 1e-9, beside = 0.2; // of the spread along the line, and of its root
  const Eigen::SelfAdjointEigenSolver<Matrix2d> axes(shares.spread);
  const double largest = std::max(axes.eigenvalues()[1], 0.);
  std::pair<Vector2d, double> change{Vector2d::Zero(), 0};
  for (Eigen::Index i = 0; i < 2; ++i)
  {
    const Vector2d axis = axes.eigenvectors().col(i);
    const double along = axis.dot(shares.centre);
    if (axes.eigenvalues()[i] > flat * largest)
    {
      change.first -= along / axes.eigenvalues()[i] * axis;
      change.second = std::max(change.second, std::abs(along));
    }
    else if (std::abs(along) > beside * std::sqrt(largest))
      return std::nullopt;
  }
  return change;
}

/// Shares of a force among the parts of a patch whose centre is `place`. Of all such shares they are the ones
/// that tell least beside the areas (maximum entropy: Sukumar, Int. J. Numer. Meth. Eng. 61, 2004, 2159),
/// which are positive. Newton's method minimizes the logarithm of their sum, which is convex. Two parts, as
/// those of a node within the side of a face, have their centre on a line; the nearest point to a place that
/// is almost on it is taken. No shares have their centre at the edge of the surface, or at a place that
/// hangs: there the area's are taken.
std::vector<double> shares_of(const std::vector<PatchPart> &parts, const Vector2d &place, const double area)
{
  constexpr unsigned int most_steps = 100;
  constexpr double rounding = 1e-9, largest_exponent = 50;
  Vector2d slope = Vector2d::Zero();
  for (unsigned int step = 0; step < most_steps && slope.norm() <= largest_exponent; ++step)
  {
    Shares shares = exponential_shares(parts, place, area, slope);
    const auto change = change_of_slope(shares);
    if (!change)
      break;
    if (change->second <= rounding)
      return shares.of_parts;
    slope += change->first / std::max(1., change->first.norm()); // far off, exponentials are not quadratic
  }
  return exponential_shares(parts, place, area, Vector2d::Zero()).of_parts;
}

bool are_opposite(const SurfacePatch::Edge &one, const SurfacePatch::Edge &other)
{
  constexpr double rounding = 1e-9;
  const PatchEdge &a = one.line, &b = other.line;
  return std::abs(one.density - other.density) <= rounding * one.density &&
         (a.from - b.to).norm() <= rounding * a.length && (a.to - b.from).norm() <= rounding * a.length;
}

/// Edges between two parts of a patch with the same traction are not edges of the patch.
void remove_inner_edges(std::vector<SurfacePatch::Edge> &edges)
{
  std::vector<SurfacePatch::Edge> outer;
  for (const SurfacePatch::Edge &edge : edges)
    if (std::none_of(edges.begin(), edges.end(),
                     [&](const SurfacePatch::Edge &other) { return are_opposite(edge, other); }))
      outer.push_back(edge);
  edges = std::move(outer);
}

SurfacePatch patch_of(const std::vector<PatchPart> &parts, const Vector2d &place, const Rules &rules)
{
  static const auto exact = gauss_rule(2);
  SurfacePatch patch;
  Vector2d centre = Vector2d::Zero();
  for (const PatchPart &part : parts)
  {
    patch.area += part.area;
    centre += part.area * part.centre;
  }
  const std::vector<double> shares =
      shares_of(parts, centre_wanted(place, centre / patch.area, patch.area), patch.area);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const Quadrilateral &corners = parts[i].corners;
    const double density = shares[i] / parts[i].area;
    at_points(corners, exact,
              [&](const Vector2d &position, const double area)
              {
                patch.centre += density * area * position;
                patch.spread += density * area * position * position.transpose();
              });
    at_points(corners, rules.points,
              [&](const Vector2d &position, const double area) {
                patch.points.push_back({position, density * area});
              });
    at_points(corners, rules.close_points,
              [&](const Vector2d &position, const double area) {
                patch.close_points.push_back({position, density * area});
              });
    for (unsigned int k = 0; k < 4; ++k)
      patch.edges.push_back({{corners[k], corners[(k + 1) % 4]}, density});
  }
  patch.spread -= patch.centre * patch.centre.transpose();
  for (const SurfacePatch::Edge &edge : patch.edges)
    patch.radius = std::max(patch.radius, (edge.line.from - patch.centre).norm());
  remove_inner_edges(patch.edges);
  return patch;
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
  std::vector<std::vector<PatchPart>> parts(whole.nodes.size());
  std::vector<Vector2d> all_places(whole.nodes.size());
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
        parts[face[i + n * j]].emplace_back(Quadrilateral{corners[first], corners[first + 1],
                                                          corners[first + n + 2], corners[first + n + 1]});
        all_places[face[i + n * j]] = places[i + n * j];
      }
  }
  std::vector<SurfacePatch> patches;
  for (std::size_t i = 0; i < parts.size(); ++i)
    patches.push_back(patch_of(parts[i], all_places[i], rules));
  return patches;
}
} // namespace orthocone
