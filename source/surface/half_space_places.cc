// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "half_space_places.h"

#include <cmath>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;

namespace
{
/// Mean over a patch of the kernel of forces that are spread over another one: the inner integral is exact,
/// the outer one a sum over points.
HalfSpaceKernel from_edges(const std::vector<SurfacePatch::Point> &points, const SurfacePatch &source)
{
  HalfSpaceKernel kernel;
  for (const SurfacePatch::Point &point : points)
    for (const SurfacePatch::Edge &edge : source.edges)
      kernel.add_edge(edge.line, point.position, point.share * edge.density);
  return kernel;
}

/// The same for patches far away. Distances between points of two patches have the sum of both spreads, and
/// so have these four distances, the columns of its symmetric root with both signs: the error falls with the
/// fourth power of size over distance, and a surface that is turned by a right angle has the same kernels.
HalfSpaceKernel from_afar(const SurfacePatch &patch, const SurfacePatch &source)
{
  const Matrix2d spread = patch.spread + source.spread;
  const double root = std::sqrt(spread.determinant());
  const Matrix2d half = (spread + root * Matrix2d::Identity()) / std::sqrt(spread.trace() + 2 * root);
  const double a = half(0, 0), b = half(0, 1), c = half(1, 1);
  const double x = patch.centre[0] - source.centre[0], y = patch.centre[1] - source.centre[1];
  HalfSpaceKernel kernel;
  kernel.add_point(x + a + b, y + b + c, 0.25);
  kernel.add_point(x + a - b, y + b - c, 0.25);
  kernel.add_point(x - a + b, y - b + c, 0.25);
  kernel.add_point(x - a - b, y - b - c, 0.25);
  return kernel;
}

HalfSpaceKernel between(const SurfacePatch &patch, const SurfacePatch &source)
{
  // No distance on a regular mesh may equal these numbers, or rounding would decide. Patches that touch are
  // next to each other. docs/theory.md, section 2, "An elastic half-space below".
  constexpr double next = 1.0123, far = 1.7183;
  if (&patch == &source)
    return from_edges(patch.close_points, source);
  const double distance = (patch.centre - source.centre).norm() / (patch.radius + source.radius);
  if (distance > far)
    return from_afar(patch, source);
  if (distance < next)
    return from_edges(patch.close_points, source)
        .mean_with(from_edges(source.close_points, patch).reversed());
  return from_edges(patch.points, source).mean_with(from_edges(source.points, patch).reversed());
}
} // namespace

HalfSpacePlaces::HalfSpacePlaces(const ContactSurface &surface, const ModelSymmetry &symmetry,
                                 const unsigned int n_points)
    : whole_(symmetry.whole(surface)),
      patches_(surface_patches(surface, whole_, n_points)),
      images_(surface.n_places()),
      n_copies_(symmetry.n_copies())
{
  for (std::size_t i = 0; i < whole_.nodes.size(); ++i)
    images_[whole_.nodes[i].node].push_back(i);
}

Matrix3d HalfSpacePlaces::displacements(const HalfSpace &half_space, const std::size_t place,
                                        const std::size_t source) const
{
  Matrix3d sum = Matrix3d::Zero();
  for (const std::size_t image : images_[source])
  {
    const Matrix3d columns = between(own(place), patches_[image]).displacements(half_space);
    const Matrix2d &mirror = whole_.images[whole_.nodes[image].image];
    sum.col(0) += mirror(0, 0) * columns.col(0);
    sum.col(1) += mirror(1, 1) * columns.col(1);
    sum.col(2) += columns.col(2);
  }
  // Of a place on itself this is symmetric, but for the error of sums over points.
  if (place == source)
    sum = (0.5 * (sum + sum.transpose())).eval();
  return sum / share(source);
}

Eigen::SparseMatrix<double> HalfSpacePlaces::division(const ContactSurface &surface) const
{
  const std::size_t n_nodes = surface.nodes.size();
  std::vector<double> areas;
  for (std::size_t i = 0; i < n_nodes; ++i)
    areas.push_back(area(i));
  for (std::size_t h = 0; h < surface.hanging.size(); ++h)
    for (const auto &[node, weight] : surface.hanging[h].terms)
      areas[node] += weight * area(n_nodes + h);
  std::vector<Eigen::Triplet<double>> shares;
  const auto divide = [&](const std::size_t place, const std::size_t node, const double weight)
  {
    for (int d = 0; d < 3; ++d)
      shares.emplace_back(3 * static_cast<int>(place) + d, 3 * static_cast<int>(node) + d,
                          weight * area(place) / areas[node]);
  };
  for (std::size_t i = 0; i < n_nodes; ++i)
    divide(i, i, 1);
  for (std::size_t h = 0; h < surface.hanging.size(); ++h)
    for (const auto &[node, weight] : surface.hanging[h].terms)
      divide(n_nodes + h, node, weight);
  Eigen::SparseMatrix<double> division(3 * static_cast<Eigen::Index>(n()),
                                       3 * static_cast<Eigen::Index>(n_nodes));
  division.setFromTriplets(shares.begin(), shares.end());
  return division;
}
} // namespace orthocone
