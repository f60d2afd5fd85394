// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/rigid_components.h>

#include <Eigen/Dense>

namespace orthocone
{
/// Motion of a rigid face: translation of its centre (mm) and rotation about it (rad). It is linearized: a
/// point moves by translation + rotation x (point - centre). A linearized rotation causes no strain.
struct RigidMotion
{
  Eigen::Matrix<double, n_rigid_components, 1> components =
      Eigen::Matrix<double, n_rigid_components, 1>::Zero();

  double operator[](const unsigned int i) const { return components[i]; }
  double &operator[](const unsigned int i) { return components[i]; }
  Eigen::Vector3d translation() const { return components.head<3>(); }
  Eigen::Vector3d rotation() const { return components.tail<3>(); }

  /// Displacement of a point that lies at `arm` (mm) from the centre, mm.
  Eigen::Vector3d at(const Eigen::Vector3d &arm) const { return translation() + rotation().cross(arm); }

  /// Upper bound of the displacement (mm) of points that are at most `radius` (mm) from the centre.
  double size(const double radius) const { return translation().norm() + radius * rotation().norm(); }

  bool operator==(const RigidMotion &other) const { return components == other.components; }
};

/// A translation, mm.
inline RigidMotion moved_by(const double ux, const double uy, const double uz)
{
  RigidMotion motion;
  motion.components.head<3>() << ux, uy, uz;
  return motion;
}

/// Force (N) on a rigid face and its moment (N mm) about the centre: the dual of RigidMotion.
struct Wrench
{
  Eigen::Matrix<double, n_rigid_components, 1> components =
      Eigen::Matrix<double, n_rigid_components, 1>::Zero();

  double operator[](const unsigned int i) const { return components[i]; }
  double &operator[](const unsigned int i) { return components[i]; }
  Eigen::Vector3d force() const { return components.head<3>(); }
  Eigen::Vector3d moment() const { return components.tail<3>(); }

  /// Adds a force (N) that acts at `arm` (mm) from the centre.
  void add(const Eigen::Vector3d &force, const Eigen::Vector3d &arm)
  {
    components.head<3>() += force;
    components.tail<3>() += arm.cross(force);
  }

  /// Work on a motion, N mm.
  double work(const RigidMotion &motion) const { return components.dot(motion.components); }
};
} // namespace orthocone
