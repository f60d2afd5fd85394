// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "face_basis.h"
#include "face_pieces.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>
#include <vector>

namespace orthocone
{
/// Whether two boxes share more than an edge.
inline bool overlap(const Eigen::AlignedBox2d &a, const Eigen::AlignedBox2d &b)
{
  return (a.max().cwiseMin(b.max()).array() > a.min().cwiseMax(b.min()).array()).all();
}

template<typename Places>
Eigen::AlignedBox2d box_of(const Places &places)
{
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d &place : places)
    box.extend(place);
  return box;
}

/// A face of a contact surface in the plane in which it is cut with faces of another one.
struct CutFace
{
  /// A triangle of its outline.
  struct Part
  {
    SignedTriangle triangle;
    Eigen::AlignedBox2d box;
  };

  /// `nodes` of the surface and their `places` in the plane (mm), lexicographic and anticlockwise; `centre`
  /// in space.
  CutFace(const unsigned int degree, std::vector<unsigned int> nodes_of_surface,
          std::vector<Eigen::Vector2d> places, Eigen::Vector3d centre_in_space,
          const bool is_projected = false)
      : nodes(std::move(nodes_of_surface)),
        centre(std::move(centre_in_space)),
        face(degree, std::move(places))
  {
    const std::vector<Eigen::Vector2d> outline = face.outline(is_projected);
    area = std::abs(signed_area(outline));
    box = box_of(outline);
    for (const SignedTriangle &triangle : triangles(outline))
      parts.push_back({triangle, box_of(triangle.corners)});
  }

  /// Area of the surface divided by that in the plane, at a point where the nodes have these values.
  double steepness(const PlaneFace::Values &values) const
  {
    return steepness_of_nodes.size() == 0 ? 1 : steepness_of_nodes.dot(values);
  }

  /// Makes it a face with these heights of its nodes above the plane, mm.
  void set_heights(const Eigen::VectorXd &heights)
  {
    const std::vector<double> &line = face.nodes();
    steepness_of_nodes.resize(heights.size());
    for (Eigen::Index i = 0, n = static_cast<Eigen::Index>(line.size()); i < heights.size(); ++i)
    {
      const Eigen::Vector2d unit(line[static_cast<std::size_t>(i % n)],
                                 line[static_cast<std::size_t>(i / n)]);
      steepness_of_nodes[i] = std::sqrt(1 + face.gradient(heights, unit).squaredNorm());
    }
  }

  std::vector<unsigned int> nodes;
  Eigen::Vector3d centre; ///< mm
  PlaneFace face;
  std::vector<Part> parts{};
  double area = 0; ///< in the plane, mm^2
  Eigen::AlignedBox2d box;
  Eigen::VectorXd steepness_of_nodes{}; ///< none of a face that lies in the plane
};

/// Calls use(polygon, sign) with the convex parts, and signs, of which the intersection of two faces is the
/// sum. What they share along an edge, by rounding, is no part.
template<typename Use>
void at_common_parts(const CutFace &own, const CutFace &other, const Use &use)
{
  constexpr double rounding = 1e-14; // of an area
  if (!overlap(own.box, other.box))
    return;
  for (const auto &[part, box] : own.parts)
    for (const auto &[of_other, other_box] : other.parts)
      if (overlap(box, other_box))
        if (const PlanePolygon common = common_part(part.corners, of_other.corners);
            signed_area(common) > rounding * own.area)
          use(common, part.sign * of_other.sign);
}
} // namespace orthocone
