// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

namespace orthocone
{
/// Local axes of the contact nodes: the normal z, and tangents x, y that are turned about it, by one angle
/// for all nodes or by one for each.
class LocalAxes
{
public:
  /// `angle`, in degrees, leads from the global to the local x axis of all nodes. Multiples of 90 degrees
  /// turn without rounding.
  explicit LocalAxes(double angle);

  /// One angle (degrees) for each node. Throws std::logic_error if there is none.
  explicit LocalAxes(const std::vector<double> &angles);

  /// Whether all nodes have one angle.
  bool is_uniform() const { return turns_.size() == 1; }

  /// Tangential vectors (x, y), in any unit, in the local axes of a node, and back in global axes.
  Eigen::Vector2d to_local(const std::size_t node, const Eigen::Vector2d &global) const
  {
    return turn(node).transpose() * global;
  }
  Eigen::Vector2d to_global(const std::size_t node, const Eigen::Vector2d &local) const
  {
    return turn(node) * local;
  }

  /// Row d: the global direction d (x, y, z) in local components (normal, x, y) of the node.
  Eigen::Matrix3d global_in_local(std::size_t node) const;

private:
  const Eigen::Matrix2d &turn(const std::size_t node) const { return turns_[is_uniform() ? 0 : node]; }

  std::vector<Eigen::Matrix2d> turns_; ///< one for all nodes, or one a node
};
} // namespace orthocone
