// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Core>

#include <array>
#include <limits>
#include <vector>

namespace orthocone
{
/// A node of the contact surface.
struct ContactNode
{
  static constexpr unsigned int no_dof = std::numeric_limits<unsigned int>::max();

  std::array<double, 2> position;     ///< x, y in mm
  double area;                        ///< lumped weight on the model's faces, or on their rings (mm^2)
  std::array<unsigned int, 3> dofs;   ///< of u_x, u_y, u_z, where this process has them
  std::array<bool, 3> is_free;        ///< false where symmetry or a support holds the direction
  double height = 0;                  ///< z in mm
  std::array<bool, 3> is_supported{}; ///< whether it is a support that holds the direction
  /// Of length 1, into the body: the mean of the faces that meet here, by what the node weighs on each.
  Eigen::Vector3d inward = Eigen::Vector3d::UnitZ();
  /// The integral of the node's weight times the normal into the body, mm^2; 0 where the counterface has the
  /// normal z.
  Eigen::Vector3d area_vector = Eigen::Vector3d::Zero();
  unsigned int surface = 0; ///< number of its contact surface; on an edge between two the smaller one

  /// The area (mm^2) by which forces are tractions on a counterface with this normal. On curved faces it
  /// makes even tractions even, and at an edge between two faces it is that of the face that touches.
  double pressed_area(const Eigen::Vector3d &normal) const
  {
    return area_vector.isZero(0) ? area : area_vector.dot(normal);
  }

  Eigen::Vector3d place() const { return {position[0], position[1], height}; } ///< mm

  /// A normal (of any length) without the component that a plane of symmetry excludes, of length 1. Of a node
  /// that is held in all directions it is the normal itself.
  Eigen::Vector3d with_symmetry(Eigen::Vector3d normal) const
  {
    if (is_on_plane(0) != is_on_plane(1) || is_free[2])
      for (unsigned int d = 0; d < 2; ++d)
        if (is_on_plane(d))
          normal[d] = 0;
    normal.normalize();
    // Axes that are those of the scene but for rounding are these: a held direction stays one.
    constexpr double rounding = 1e-11;
    return (normal.array().abs() < rounding).select(0, normal).normalized();
  }

  /// Whether the node lies on the plane of symmetry that is normal to x (0) or y (1), or on the axis.
  bool is_on_plane(const unsigned int direction) const
  {
    return !is_free[direction] && !is_supported[direction];
  }

  /// Whether this process has the node's part of the body; exactly one process does.
  bool is_here() const { return dofs[2] != no_dof; }
};

/// A place where a face borders on smaller ones. Its displacement and its fields are interpolated on the
/// larger face, as sums over contact nodes. The contact law does not hold there (docs/theory.md, section 2,
/// "Hanging nodes").
struct HangingNode
{
  /// A contact node and its weight in the sum.
  struct Term
  {
    unsigned int node;
    double weight;
  };

  ContactNode place; ///< without area
  std::vector<Term> terms;
};

/// Contact nodes and the faces between them, without any type of a mesh library.
struct ContactSurface
{
  unsigned int degree = 1;
  std::vector<ContactNode> nodes;
  std::vector<HangingNode> hanging{};
  /// (degree + 1)^2 places for each face, lexicographic; degree + 1 from the axis outwards in a section
  std::vector<std::vector<unsigned int>> faces;

  /// Places are contact nodes, then hanging nodes.
  std::size_t n_places() const { return nodes.size() + hanging.size(); }

  /// Place i, which may be a hanging node.
  const ContactNode &place(const std::size_t i) const
  {
    return i < nodes.size() ? nodes[i] : hanging[i - nodes.size()].place;
  }
};
} // namespace orthocone
