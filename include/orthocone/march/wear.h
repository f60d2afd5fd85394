// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>

#include <Eigen/Core>

namespace orthocone
{
/// The depth that slip wears off the base of the body, by the law that is chosen.
class WearLaw
{
public:
  /// A law without wear.
  WearLaw() = default;

  /// The law of the options, with the areas (mm^2) of the contact nodes, Scene::pressed_areas().
  WearLaw(const WearOptions &options, Eigen::VectorXd areas);

  /// Depth that a node (index in the model) loses, mm.
  double depth(Eigen::Index node, const Rubbing &rubbing) const;

  const WearOptions &options() const { return options_; }

private:
  WearOptions options_{};
  Eigen::VectorXd areas_{}; ///< of the nodes, mm^2
};
} // namespace orthocone
