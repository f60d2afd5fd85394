// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/expression.h>
#include <orthocone/scene/obstacle.h>

namespace orthocone
{
/// A rigid surface by its signed distance, Obstacle/Distance: positive outside. The gap of a point is its
/// value there, and the normal the gradient.
class GivenDistance : public Obstacle
{
public:
  explicit GivenDistance(const std::string &distance)
      : distance_(distance)
  {
  }

  std::string entry() const override { return "Obstacle/Distance"; }
  double gap(const SurfacePoint &point) const override { return at(point.place); }
  bool has_normal_z() const override { return false; }
  std::vector<Eigen::Vector3d> normals(const std::vector<SurfacePoint> &points) const override;
  void check(const std::vector<SurfacePoint> &points) const override;
  std::vector<std::string> warnings(const std::vector<SurfacePoint> &points) const override;

private:
  /// A gradient, and whether it is the mean of both sides of an edge.
  struct Gradient
  {
    Eigen::Vector3d value;
    bool is_at_edge;
  };

  double at(const Eigen::Vector3d &place) const { return distance_.value(place[0], place[1], place[2]); }
  Eigen::Vector3d differences(const Eigen::Vector3d &place, double step) const;
  bool has_edge(const Eigen::Vector3d &place, double reach) const;
  Gradient gradient(const Eigen::Vector3d &place, double reach) const;
  std::vector<Gradient> gradients(const std::vector<SurfacePoint> &points) const;

  Expression distance_;
};
} // namespace orthocone
