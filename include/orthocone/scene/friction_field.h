// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/friction_law.h>
#include <orthocone/scene/surface_sample.h>
#include <orthocone/surface/local_axes.h>

#include <string>
#include <vector>

namespace orthocone
{
/// The friction law at each place of the contact surface, and the axes of its ellipses.
class FrictionField
{
public:
  explicit FrictionField(const FrictionOptions &options)
      : options_(options)
  {
  }

  bool varies() const { return options_.varies(); }

  /// Throws InputError unless there is a law at all these places (mm).
  void check(const std::vector<Eigen::Vector2d> &places) const;

  /// The laws of the n contact nodes, along their local axes.
  std::vector<OrthotropicFriction> laws(const ContactSurface &surface, const ModelSymmetry &symmetry) const;

  /// Local axes of the contact nodes; in a section without a third component they are its own.
  LocalAxes axes(const ContactSurface &surface, const ModelSymmetry &symmetry) const;

  /// Why friction does not have the symmetry of a model; empty if it does.
  std::string asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample) const;

  /// Entries of both ellipses as tensors in global axes, at a place (mm): six numbers that vary as smoothly
  /// as friction does; they may be NaN.
  Eigen::Matrix<double, 6, 1> tensors(const Eigen::Vector2d &place) const;

private:
  std::string constant_asymmetry(const ModelSymmetry &symmetry) const;

  FrictionOptions options_;
};
} // namespace orthocone
