// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/friction_law.h>
#include <orthocone/scene/obstacle.h>
#include <orthocone/surface/local_axes.h>

#include <string>
#include <vector>

namespace orthocone
{
/// The friction law at each place of the contact surface, and its axes there.
class FrictionField
{
public:
  explicit FrictionField(const FrictionOptions &options)
      : options_(options)
  {
  }

  bool varies() const { return options_.varies(); }

  /// Throws InputError unless there is a law with axes at all these points.
  void check(const std::vector<SurfacePoint> &points) const;

  /// The laws of the n contact nodes, along their local axes.
  std::vector<FrictionLaw> laws(const ContactSurface &surface, const Obstacle &obstacle,
                                const ModelSymmetry &symmetry) const;

  /// Local axes of the contact nodes on an obstacle; in a section without a third component they are its own.
  /// Throws InputError where orthotropic friction has its first axis along the normal.
  LocalAxes axes(const ContactSurface &surface, const Obstacle &obstacle,
                 const ModelSymmetry &symmetry) const;

  /// Why friction on an obstacle does not have the symmetry of a model; empty if it does.
  std::string asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample,
                        const Obstacle &obstacle) const;

  /// Numbers that vary as smoothly over the surface as friction does, at a place (mm): entries of both
  /// ellipses as tensors in global axes, or forces against slip in several directions where there are no
  /// ellipses. They are as many at all places, and may be NaN.
  Eigen::VectorXd numbers(const Eigen::Vector3d &place) const;

private:
  /// The law at a place (mm) along the axes there. Throws InputError if there is none.
  FrictionLaw law(const Eigen::Vector3d &place) const;

  /// Degrees from x to the first axis at a place (mm), where the normal is z.
  double angle(const Eigen::Vector3d &place) const;

  /// Whether the axes are those of an angle about z.
  bool has_angle(const Obstacle &obstacle) const { return obstacle.has_normal_z() && !options_.first_axis; }

  /// The direction whose projection is the first axis at a place (mm).
  Eigen::Vector3d first_axis(const Eigen::Vector3d &place) const;

  /// Axes (normal, first, second tangent) at points with these normals.
  std::vector<Eigen::Matrix3d> frames(const std::vector<SurfacePoint> &points,
                                      const std::vector<Eigen::Vector3d> &normals) const;

  std::vector<FrictionLaw> laws_in_section(const std::vector<SurfacePoint> &points,
                                           const Obstacle &obstacle) const;

  std::string constant_asymmetry(const ModelSymmetry &symmetry) const;
  std::string asymmetry_of_maps(const ModelSymmetry &symmetry, const std::vector<SurfacePoint> &points) const;
  std::string asymmetry_of_frames(const ModelSymmetry &symmetry, const std::vector<SurfacePoint> &points,
                                  const Obstacle &obstacle) const;

  FrictionOptions options_;
};
} // namespace orthocone
