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
/// The friction law at each place of the contact surface, and its axes there.
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
  std::vector<FrictionLaw> laws(const ContactSurface &surface, const ModelSymmetry &symmetry) const;

  /// Local axes of the contact nodes; in a section without a third component they are its own.
  LocalAxes axes(const ContactSurface &surface, const ModelSymmetry &symmetry) const;

  /// Why friction does not have the symmetry of a model; empty if it does.
  std::string asymmetry(const ModelSymmetry &symmetry, const SurfaceSample &sample) const;

  /// Numbers that vary as smoothly over the surface as friction does, at a place (mm): entries of both
  /// ellipses as tensors in global axes, or forces against slip in several directions where there are no
  /// ellipses. They are as many at all places, and may be NaN.
  Eigen::VectorXd numbers(const Eigen::Vector2d &place) const;

private:
  /// The law at a place (mm) along the axes there. Throws InputError if there is none.
  FrictionLaw law(const Eigen::Vector2d &place) const;

  /// Degrees from x to the first axis at a place (mm).
  double angle(const Eigen::Vector2d &place) const;

  std::string constant_asymmetry(const ModelSymmetry &symmetry) const;
  std::string asymmetry_of_maps(const ModelSymmetry &symmetry,
                                const std::vector<Eigen::Vector2d> &places) const;

  FrictionOptions options_;
};
} // namespace orthocone
