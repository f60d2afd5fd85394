// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

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
  double height = 0;                  ///< z in mm; 0 where the base is flat
  std::array<bool, 3> is_supported{}; ///< whether it is a support that holds the direction

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
