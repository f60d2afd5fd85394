// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "half_space_nodes.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::SparseMatrix;
using Eigen::VectorXd;

namespace
{
std::vector<Eigen::Vector2d> points_of_places(const ContactSurface &surface)
{
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < surface.n_places(); ++i)
    points.emplace_back(surface.place(i).position[0], surface.place(i).position[1]);
  return points;
}

/// Leads from local components at the contact nodes to global ones, of the directions that are free or of
/// those that symmetry holds.
SparseMatrix<double> turns(const ContactSurface &surface, const LocalAxes &axes, const bool is_free)
{
  const Index n = 3 * static_cast<Index>(surface.nodes.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      if (surface.nodes[i].is_free[d] == is_free)
        for (Index local = 0; local < 3; ++local)
          entries.emplace_back(3 * static_cast<int>(i) + static_cast<int>(d),
                               3 * static_cast<int>(i) + static_cast<int>(local),
                               axes.global_in_local(i)(d, local));
  SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The places over which the forces on a node are spread, and how.
std::vector<std::pair<std::size_t, Matrix3d>> shares_of(const SparseMatrix<double> &spread, const Index node)
{
  std::vector<std::pair<std::size_t, Matrix3d>> shares;
  for (Index local = 0; local < 3; ++local)
    for (SparseMatrix<double>::InnerIterator entry(spread, 3 * node + local); entry; ++entry)
    {
      const auto place = static_cast<std::size_t>(entry.row() / 3);
      auto found =
          std::find_if(shares.begin(), shares.end(), [&](const auto &share) { return share.first == place; });
      if (found == shares.end())
        found = shares.insert(found, {place, Matrix3d::Zero()});
      found->second(entry.row() % 3, local) = entry.value();
    }
  return shares;
}
} // namespace

HalfSpaceNodes::HalfSpaceNodes(const HalfSpace &half_space, const ContactSurface &surface,
                               const ModelSymmetry &symmetry, const LocalAxes &axes)
    : half_space_(half_space),
      places_(surface, symmetry, half_space.n_points),
      points_(points_of_places(surface)),
      spread_(places_.division(surface) * turns(surface, axes, true))
{
  // A held direction gets the compliance of its node along z.
  const Spread division = places_.division(surface), held = turns(surface, axes, false);
  VectorXd along_z(held.rows());
  for (Index i = 0; i < held.rows(); ++i)
    along_z[i] = block(division, i / 3, i / 3)(2, 2);
  held_ = Spread(held.transpose()) * (along_z.asDiagonal() * held);
}

/// Of two places, from the same half of the matrix as that of half_space_compliance().
Matrix3d HalfSpaceNodes::between(const std::size_t place, const std::size_t source) const
{
  return place >= source ? places_.displacements(half_space_, place, source)
                         : Matrix3d(places_.displacements(half_space_, source, place).transpose());
}

/// S^T W_p S of two nodes for any S.
Matrix3d HalfSpaceNodes::block(const Spread &spread, const Index node, const Index source) const
{
  Matrix3d sum = Matrix3d::Zero();
  for (const auto &[i, on_i] : shares_of(spread, node))
    for (const auto &[j, on_j] : shares_of(spread, source))
      sum += on_i.transpose() * between(i, j) * on_j;
  return sum;
}

Matrix3d HalfSpaceNodes::block(const Index node, const Index source) const
{
  return block(spread_, node, source) + Matrix3d(held_.block(3 * node, 3 * source, 3, 3));
}

HierarchicalMatrix HalfSpaceNodes::between_places(const double accuracy,
                                                  const HierarchicalMatrix::Pivots pivots) const
{
  return {points_, [this](const std::size_t i, const std::size_t j) { return between(i, j); }, accuracy,
          pivots};
}

NodeVector HalfSpaceNodes::product(const HierarchicalMatrix &between_places, const NodeVector &force) const
{
  VectorXd of_places;
  between_places.vmult(of_places, spread_ * force);
  return spread_.transpose() * of_places + held_ * force;
}

std::vector<std::vector<Index>> HalfSpaceNodes::neighbours(const std::size_t n_nearest) const
{
  const auto distance = [&](const Index a, const std::size_t b)
  { return (points_[static_cast<std::size_t>(a)] - points_[b]).squaredNorm(); };
  std::vector<std::vector<Index>> nearest(static_cast<std::size_t>(n()));
  std::vector<Index> nodes(nearest.size());
  for (std::size_t i = 0; i < nearest.size(); ++i)
  {
    std::iota(nodes.begin(), nodes.end(), 0);
    const auto last = nodes.begin() + static_cast<std::ptrdiff_t>(std::min(n_nearest, nodes.size()));
    std::partial_sort(nodes.begin(), last, nodes.end(),
                      [&](const Index a, const Index b) { return distance(a, i) < distance(b, i); });
    nearest[i].assign(nodes.begin(), last);
  }
  return nearest;
}
} // namespace orthocone
