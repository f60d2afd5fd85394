// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "half_space_places.h"
#include "hierarchical_matrix.h"

namespace orthocone
{
/// The compliance of a half-space between contact nodes, block by block: W = S^T W_p S + H, where W_p is the
/// compliance between places in global axes, S spreads local forces of nodes over places, and H is the
/// compliance of directions that symmetry holds. The entries are those of half_space_compliance().
class HalfSpaceNodes
{
public:
  HalfSpaceNodes(const HalfSpace &half_space, const ContactSurface &surface, const ModelSymmetry &symmetry,
                 const LocalAxes &axes);

  Eigen::Index n() const { return spread_.cols() / 3; }

  /// The 3 x 3 block of W of two nodes, in their local axes, mm/N.
  Eigen::Matrix3d block(Eigen::Index node, Eigen::Index source) const;

  /// W_p as a hierarchical matrix.
  HierarchicalMatrix between_places(double accuracy, HierarchicalMatrix::Pivots pivots) const;

  /// W force with such a matrix, 3 n, mm.
  NodeVector product(const HierarchicalMatrix &between_places, const NodeVector &force) const;

  /// For each node the `n_nearest` nodes that are nearest to it, itself first.
  std::vector<std::vector<Eigen::Index>> neighbours(std::size_t n_nearest) const;

private:
  using Spread = Eigen::SparseMatrix<double>;

  Eigen::Matrix3d between(std::size_t place, std::size_t source) const;
  Eigen::Matrix3d block(const Spread &spread, Eigen::Index node, Eigen::Index source) const;

  HalfSpace half_space_;
  HalfSpacePlaces places_;
  std::vector<Eigen::Vector2d> points_; ///< of the places, mm
  Spread spread_;                       ///< S, 3 places x 3 nodes
  Spread held_;                         ///< H, 3 nodes x 3 nodes, mm/N
};
} // namespace orthocone
