// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <vector>

namespace orthocone
{
/// Places of a face's nodes on the unit interval: the degree + 1 points of Gauss and Lobatto. Throws
/// std::logic_error unless the degree is 1 to 3.
const std::vector<double> &face_nodes(unsigned int degree);

/// Gauss points and weights on (0, 1). Points of a pair are mirror images to the last bit.
std::vector<std::array<double, 2>> gauss_rule(unsigned int n);

/// A face in the plane z = 0, interpolated between its nodes.
class PlaneFace
{
public:
  /// One number for each node, up to degree 3, without memory from the heap.
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 16, 1>;

  /// `places`: (degree + 1)^2 points (x, y), lexicographic, mm.
  PlaneFace(unsigned int degree, std::vector<Eigen::Vector2d> places);

  /// Values of all nodes at a point of the unit square, in their order.
  Values values(const Eigen::Vector2d &unit) const;

  Eigen::Vector2d position(const Eigen::Vector2d &unit) const;

  /// Places of the nodes along both directions of the unit square.
  const std::vector<double> &nodes() const { return nodes_; }

  /// The gradient with respect to the position of a field with these values at the nodes, in its unit per mm.
  Eigen::Vector2d gradient(const Eigen::VectorXd &field, const Eigen::Vector2d &unit) const;

  /// The point of the unit square, or close to it, that has this position (mm). A `guess` that is close to it
  /// takes fewer iterations.
  Eigen::Vector2d unit_of(const Eigen::Vector2d &position, const Eigen::Vector2d &guess = {0.5, 0.5}) const;

  /// Corners (mm) of a polygon along the edges: straight edges stay, curved ones become short pieces. Nodes
  /// of a projected face need not be evenly spaced on a straight edge.
  std::vector<Eigen::Vector2d> outline(bool is_projected = false) const;

private:
  bool is_straight(unsigned int edge, bool is_projected) const;

  const std::vector<double> &nodes_;
  std::vector<Eigen::Vector2d> places_;
};
} // namespace orthocone
