// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/surface_sample.h>
#include <orthocone/surface/compliance.h>

#include <memory>
#include <string>
#include <vector>

namespace orthocone
{
/// What the body rests on: a rigid surface at a gap (mm, > 0 open) below the plane z = 0. A new obstacle is a
/// class of this kind and a line in make_obstacle().
class Obstacle
{
public:
  virtual ~Obstacle() = default;

  virtual bool is_plane() const { return false; }

  /// Gap below the plane z = 0, mm; may be NaN where check() has not been asked.
  virtual double gap(const Eigen::Vector2d &place) const = 0;

  /// Throws InputError unless there is a gap at all these places.
  virtual void check(const std::vector<Eigen::Vector2d> &places) const = 0;

  /// Why the gap is not as symmetric as a model; empty if it is.
  std::string asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample) const;
};

/// The plane z = 0, or the gap of an expression and a file. Throws FileError or InputError for the file.
std::unique_ptr<const Obstacle> make_obstacle(const ObstacleOptions &options);

/// Gaps (mm) of the contact nodes before anything moves, and no slip: three a node.
NodeVector gaps_of(const Obstacle &obstacle, const ContactSurface &surface);
} // namespace orthocone
