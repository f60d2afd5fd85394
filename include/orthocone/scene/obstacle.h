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
/// What the body rests on: a surface at a gap (mm, > 0 open) below the plane z = 0, rigid or with a
/// compliance of its own. A new obstacle is a class of this kind and a line in make_obstacle().
class Obstacle
{
public:
  virtual ~Obstacle() = default;

  virtual bool is_plane() const { return false; }

  /// Gap below the plane z = 0, mm; may be NaN where check() has not been asked.
  virtual double gap(const Eigen::Vector2d &place) const = 0;

  /// Throws InputError unless there is a gap at all these places.
  virtual void check(const std::vector<Eigen::Vector2d> &places) const = 0;

  /// Material of the half-space that stands for what gives way below the contact nodes, or nothing: rigid.
  virtual std::optional<MaterialOptions> material() const { return std::nullopt; }

  /// How its surface gives way at the contact nodes of a model: forces r that it puts on the body (N) move it
  /// by -W r (mm). 3 n x 3 n, local axes, symmetric, not negative; no rows where it is rigid.
  virtual Eigen::MatrixXd compliance(const ContactSurface &surface, const ModelSymmetry &symmetry,
                                     const LocalAxes &axes) const;

  /// Why the obstacle is not as symmetric as a model; empty if it is.
  std::string asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample) const;
};

/// The plane z = 0, or the gap of an expression and a file, on what the options name. Throws FileError or
/// InputError for the file.
std::unique_ptr<const Obstacle> make_obstacle(const ObstacleOptions &options);

/// Gaps (mm) of the contact nodes before anything moves, and no slip: three a node.
NodeVector gaps_of(const Obstacle &obstacle, const ContactSurface &surface);
} // namespace orthocone
