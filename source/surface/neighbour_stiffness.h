// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <functional>
#include <vector>

namespace orthocone
{
/// About the inverse of a compliance W, relative to a scale and in single precision: for each node its
/// nearest neighbours are held, and the others carry no force. The inverse of a compliance decreases so fast
/// with the distance that more neighbours make no better preconditioner.
class NeighbourStiffness
{
public:
  static constexpr Eigen::Index n_held = 8; ///< a node and its neighbours

  /// `scale` (mm/N) > 0.
  NeighbourStiffness(Eigen::Index n_nodes, double scale);

  /// Holds some nodes, n_held at most, for the first one of them. `block` is the 3 x 3 block of W (mm/N) of
  /// two nodes. Returns the least pivot of these nodes (mm/N), the compliance of one direction where all
  /// before are held, or 0 where rounding leaves none.
  double hold(const std::vector<Eigen::Index> &nodes,
              const std::function<Eigen::Matrix3d(Eigen::Index, Eigen::Index)> &block);

  /// About scale W^-1 vector, after hold() of all nodes.
  Eigen::VectorXf operator*(const Eigen::VectorXf &vector) const;

private:
  double scale_;
  Eigen::Matrix<Eigen::Index, n_held, Eigen::Dynamic> held_;        ///< the nodes held for each node
  Eigen::Matrix<float, 3 * n_held, Eigen::Dynamic> holding_forces_; ///< on them, 3 columns a node
};
} // namespace orthocone
