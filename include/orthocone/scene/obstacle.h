// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/surface_sample.h>
#include <orthocone/surface/compliance.h>
#include <orthocone/surface/local_axes.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// The obstacle that the body is pressed on, rigid or with a compliance of its own: its distance from the
/// places of the body's contact surface (mm, > 0 open), and its normals there. A new obstacle is a class
/// derived from this one and a kind in kinds_of<ObstacleKindOptions>().
class Obstacle
{
public:
  virtual ~Obstacle() = default;

  /// Whether it is the plane z = 0.
  virtual bool is_plane() const { return false; }

  /// The entry that says where it is, as messages name it.
  virtual std::string entry() const { return "Obstacle/Gap"; }

  /// Gap between a point of the body's surface and the obstacle, along the normal there, mm; it may be NaN at
  /// points that check() has not accepted.
  virtual double gap(const SurfacePoint &point) const = 0;

  /// Whether its normal is z at every point.
  virtual bool has_normal_z() const { return true; }

  /// Its normals at all of these points, of length 1 and into the body. Throws InputError where it has none.
  virtual std::vector<Eigen::Vector3d> normals(const std::vector<SurfacePoint> &points) const
  {
    return std::vector<Eigen::Vector3d>(points.size(), Eigen::Vector3d::UnitZ());
  }

  /// Throws InputError unless there is a gap at all these points.
  virtual void check(const std::vector<SurfacePoint> &points) const = 0;

  /// What is doubtful about it at these points, a sentence each.
  virtual std::vector<std::string> warnings(const std::vector<SurfacePoint> &) const { return {}; }

  /// Material of the half-space that stands for what deforms below the contact nodes; nothing for a rigid
  /// obstacle.
  virtual std::optional<MaterialOptions> material() const { return std::nullopt; }

  /// Compliance of its surface at the contact nodes of a model: forces r (N) that it exerts on the body move
  /// it by -W r (mm). W is 3 n x 3 n in local axes, symmetric and positive semidefinite; it has no rows where
  /// the obstacle is rigid.
  virtual Eigen::MatrixXd compliance(const ContactSurface &surface, const ModelSymmetry &symmetry,
                                     const LocalAxes &axes) const;

  /// The same compliance known by its products alone, for bodies without a dense one; null where there is
  /// none.
  virtual std::unique_ptr<const Compliance> compliance_by_products(const ContactSurface &surface,
                                                                   const ModelSymmetry &symmetry,
                                                                   const LocalAxes &axes) const;

  /// Why the obstacle does not have the symmetry of a model; empty if it does.
  std::string asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample) const;
};

/// The obstacle of the options: the plane z = 0, the gap of an expression and a file, or a distance, on a
/// rigid or an elastic ground. Throws FileError or InputError for the file.
std::unique_ptr<const Obstacle> make_obstacle(const ObstacleOptions &options);

/// Gaps of the contact nodes before anything moves, without slip: 3 n, mm.
NodeVector gaps_of(const Obstacle &obstacle, const ContactSurface &surface);
} // namespace orthocone
