// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

namespace orthocone
{
/// Local axes of the contact nodes: the normal, which points from the counterface into the body, and two
/// tangents. They are orthonormal, and right-handed in the order normal, first, second tangent.
class LocalAxes
{
public:
  /// The normal z and tangents x, y that are turned about it. `angle`, in degrees, leads from the global to
  /// the local x axis of all nodes. Multiples of 90 degrees turn without rounding.
  explicit LocalAxes(double angle);

  /// One angle (degrees) for each node. Throws std::logic_error if there is none.
  explicit LocalAxes(const std::vector<double> &angles);

  /// One orthogonal matrix for each node, as global_in_local() returns them. Throws std::logic_error if there
  /// is none.
  explicit LocalAxes(std::vector<Eigen::Matrix3d> frames);

  /// Whether all nodes have the same axes.
  bool is_uniform() const { return frames_.size() == 1; }

  /// Row d: the global direction d (x, y, z) in local components (normal, first, second) of the node. Columns
  /// are the local axes in global components.
  const Eigen::Matrix3d &global_in_local(const std::size_t node) const
  {
    return frames_[is_uniform() ? 0 : node];
  }

  Eigen::Vector3d normal(const std::size_t node) const { return global_in_local(node).col(0); }

  /// A vector along the surface, given by its components along both tangents, in global axes and in its unit.
  Eigen::Vector3d to_global(const std::size_t node, const Eigen::Vector2d &tangential) const
  {
    return global_in_local(node).rightCols<2>() * tangential;
  }

private:
  std::vector<Eigen::Matrix3d> frames_; ///< one for all nodes, or one a node
};

/// The axes of one node with the normal z, as those of LocalAxes(angle).
Eigen::Matrix3d axes_about_z(double angle);

/// The axes of one node with this normal (of length 1), whose first tangent is the projection of `along` on
/// the tangent plane. Throws std::domain_error where `along` has no projection, because it is normal itself.
Eigen::Matrix3d axes_along(const Eigen::Vector3d &normal, const Eigen::Vector3d &along);
} // namespace orthocone
