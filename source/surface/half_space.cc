// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/half_space.h>

#include "half_space_patches.h"

#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
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

/// The places of a model, their patches and the images of these.
class Places
{
public:
  Places(const ContactSurface &surface, const ModelSymmetry &symmetry, const unsigned int n_points)
      : whole_(symmetry.whole(surface)),
        patches_(surface_patches(surface, whole_, n_points)),
        images_(surface.n_places()),
        n_copies_(symmetry.n_copies())
  {
    for (std::size_t i = 0; i < whole_.nodes.size(); ++i)
      images_[whole_.nodes[i].node].push_back(i);
  }

  std::size_t n() const { return images_.size(); }

  /// Area of the patch within the model, mm^2.
  double area(const std::size_t place) const { return share(place) * own(place).area; }

  /// Displacement of a place by unit forces of the model at another place. They stand for the forces at all
  /// its images.
  Matrix3d displacements(const HalfSpace &half_space, const std::size_t place, const std::size_t source) const
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
    return sum / share(source);
  }

private:
  double share(const std::size_t place) const
  {
    return static_cast<double>(images_[place].size()) / n_copies_;
  }

  /// The patch of the place itself: its first image, since the model comes first.
  const SurfacePatch &own(const std::size_t place) const { return patches_[images_[place].front()]; }

  WholeSurface whole_;
  std::vector<SurfacePatch> patches_; ///< of the whole surface
  std::vector<std::vector<std::size_t>> images_;
  unsigned int n_copies_;
};

/// The compliance between all places, in global axes; its lower half only.
MatrixXd between_places(const HalfSpace &half_space, const Places &places)
{
  MatrixXd matrix = MatrixXd::Zero(3 * places.n(), 3 * places.n());
  for (std::size_t j = 0; j < places.n(); ++j)
    for (std::size_t i = j; i < places.n(); ++i)
      matrix.block<3, 3>(3 * static_cast<Index>(i), 3 * static_cast<Index>(j)) =
          places.displacements(half_space, i, j);
  return matrix;
}

/// Takes the hanging places out. Their tractions are sums over contact nodes, so that a node stands for parts
/// of their patches, too: its force is divided among places, and its displacement is the mean over these.
MatrixXd without_hanging(const MatrixXd &matrix, const ContactSurface &surface, const Places &places)
{
  const std::size_t n = surface.nodes.size();
  Eigen::VectorXd area(n);
  for (std::size_t i = 0; i < n; ++i)
    area[static_cast<Index>(i)] = places.area(i);
  for (std::size_t h = 0; h < surface.hanging.size(); ++h)
    for (const auto &[node, weight] : surface.hanging[h].terms)
      area[node] += weight * places.area(n + h);
  std::vector<Eigen::Triplet<double>> shares;
  const auto divide = [&](const std::size_t place, const std::size_t node, const double weight)
  {
    for (int d = 0; d < 3; ++d)
      shares.emplace_back(3 * static_cast<int>(place) + d, 3 * static_cast<int>(node) + d,
                          weight * places.area(place) / area[static_cast<Index>(node)]);
  };
  for (std::size_t i = 0; i < n; ++i)
    divide(i, i, 1);
  for (std::size_t h = 0; h < surface.hanging.size(); ++h)
    for (const auto &[node, weight] : surface.hanging[h].terms)
      divide(n + h, node, weight);
  Eigen::SparseMatrix<double> division(matrix.rows(), 3 * static_cast<Index>(n));
  division.setFromTriplets(shares.begin(), shares.end());
  return division.transpose() * (matrix.selfadjointView<Eigen::Lower>() * MatrixXd(division));
}

/// Gives directions that symmetry holds any positive compliance, as a body does.
void hold(MatrixXd &matrix, const std::vector<ContactNode> &nodes)
{
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (Index d = 0; d < 3; ++d)
      if (const Index row = 3 * static_cast<Index>(i) + d; !nodes[i].is_free[d])
      {
        matrix.row(row).setZero();
        matrix.col(row).setZero();
        matrix(row, row) = matrix(row + 2 - d, row + 2 - d);
      }
}

/// Turns the lower half into the local axes of the nodes.
void turn(MatrixXd &matrix, const LocalAxes &axes)
{
  const auto n = static_cast<std::size_t>(matrix.rows() / 3);
  std::vector<Matrix3d> turns;
  for (std::size_t i = 0; i < n; ++i)
    turns.push_back(axes.global_in_local(i));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = j; i < n; ++i)
    {
      auto block = matrix.block<3, 3>(3 * static_cast<Index>(i), 3 * static_cast<Index>(j));
      block = (turns[i].transpose() * block * turns[j]).eval();
    }
}
/// Fills the upper half from the lower one, in squares that fit into the cache.
void mirror(MatrixXd &matrix)
{
  constexpr Index side = 96;
  const Index n = matrix.rows();
  for (Index j = 0; j < n; j += side)
    for (Index i = j; i < n; i += side)
    {
      const Index n_i = std::min(side, n - i), n_j = std::min(side, n - j);
      const MatrixXd square = matrix.block(i, j, n_i, n_j);
      if (i > j)
        matrix.block(j, i, n_j, n_i) = square.transpose();
      else
        matrix.block(j, i, n_j, n_i) = square.selfadjointView<Eigen::Lower>();
    }
}
} // namespace

MatrixXd half_space_compliance(const HalfSpace &half_space, const ContactSurface &surface,
                               const ModelSymmetry &symmetry, const LocalAxes &axes)
{
  if (symmetry.is_section())
    throw std::logic_error("a half-space has no compliance of rings or strips");
  const Places places(surface, symmetry, half_space.n_points);
  MatrixXd matrix = between_places(half_space, places);
  if (!surface.hanging.empty())
    matrix = without_hanging(matrix, surface, places);
  hold(matrix, surface.nodes);
  turn(matrix, axes);
  mirror(matrix);
  return matrix;
}
} // namespace orthocone
