// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body_points.h>
#include <orthocone/scene/options.h>
#include <orthocone/surface/model_symmetry.h>

#include <optional>
#include <vector>

namespace orthocone
{
/// The points of a line of the whole body, found in the modelled part of the body, and below z = 0 in that of
/// the lower body. What is not modelled is mirrored, turned about the axis, or moved along y.
class LinePoints
{
public:
  /// `lower` is null where there is no lower body. The bodies must outlive this object. Throws InputError for
  /// a point that lies in no body; `parameters` say which are.
  LinePoints(const Line &line, const Parameters &parameters, const ModelSymmetry &symmetry, const Body &upper,
             const Body *lower);

  std::size_t size() const { return points_.size(); }

  /// Where point i is in the whole body, mm.
  const Eigen::Vector3d &place(const std::size_t i) const { return points_[i].place; }

  /// The place of the model that has it as its image, mm, and the map (2 x 2) from there.
  const Eigen::Vector3d &model_place(const std::size_t i) const { return points_[i].in_model; }
  const Eigen::Matrix2d &map(const std::size_t i) const { return points_[i].maps.front(); }

  /// The face of the upper body's contact surface on which point i lies, if it does.
  std::optional<unsigned int> contact_face(const std::size_t i) const;

  bool is_in_lower() const { return !of_lower_.empty(); }

  /// Fields at the points, in global axes. `lower`, of the lower body or its mirror image, counts if
  /// is_in_lower().
  std::vector<PointFields> fields(const Deformation &upper, const Deformation &lower) const;

private:
  /// On a plane of symmetry, or on the axis, a point is its own image under several maps: it has the mean of
  /// their fields.
  struct Point
  {
    Eigen::Vector3d place, in_model;
    std::vector<Eigen::Matrix2d> maps;
    bool is_in_lower;
    std::size_t number; ///< among the points of its body
  };
  void find_lower_points(const Body &upper);
  void require_inside(const Line &line, const Parameters &parameters, const ModelSymmetry &symmetry) const;
  bool is_inside(const Point &point, const ModelSymmetry &symmetry) const;

  bool lower_is_mirrored_;
  std::vector<Point> points_;
  std::optional<BodyPoints> upper_;  ///< always there
  std::vector<BodyPoints> of_lower_; ///< one, or none where no point lies there
};

/// Throws InputError where a line leaves the bodies. It makes their meshes, and factorizes nothing.
void require_lines_inside(const Parameters &parameters, const ModelSymmetry &symmetry);
} // namespace orthocone
