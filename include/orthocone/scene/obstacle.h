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
/// The obstacle that the body rests on: a surface at a gap (mm, > 0 open) below the plane z = 0, rigid or
/// with a compliance of its own. A new obstacle is a class derived from this one and a line in
/// make_obstacle().
class Obstacle
{
public:
  virtual ~Obstacle() = default;

  virtual bool is_plane() const { return false; }

  /// Gap below the plane z = 0 at a place (mm), mm; it may be NaN at places that check() has not accepted.
  virtual double gap(const Eigen::Vector2d &place) const = 0;

  /// Throws InputError unless there is a gap at all these places (mm).
  virtual void check(const std::vector<Eigen::Vector2d> &places) const = 0;

  /// Material of the half-space that stands for what deforms below the contact nodes; nothing for a rigid
  /// obstacle.
  virtual std::optional<MaterialOptions> material() const { return std::nullopt; }

  /// Compliance of its surface at the contact nodes of a model: forces r (N) that it exerts on the body move
  /// it by -W r (mm). W is 3 n x 3 n in local axes, symmetric and positive semidefinite; it has no rows where
  /// the obstacle is rigid.
  virtual Eigen::MatrixXd compliance(const ContactSurface &surface, const ModelSymmetry &symmetry,
                                     const LocalAxes &axes) const;

  /// Why the obstacle does not have the symmetry of a model; empty if it does.
  std::string asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample) const;
};

/// The obstacle of the options: the plane z = 0, or the gap of an expression and a file, on a rigid or an
/// elastic ground. Throws FileError or InputError for the file.
std::unique_ptr<const Obstacle> make_obstacle(const ObstacleOptions &options);

/// Gaps of the contact nodes before anything moves, without slip: 3 n, mm.
NodeVector gaps_of(const Obstacle &obstacle, const ContactSurface &surface);
} // namespace orthocone
