// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>
#include <orthocone/surface/contact_surface.h>

#include <Eigen/Core>

namespace orthocone
{
/// Areas of the contact nodes, mm^2.
Eigen::VectorXd areas_of(const ContactSurface &surface);

/// A node's slip along the obstacle in one solved step.
struct Rubbing
{
  double normal_force = 0; ///< mean over the step, N; 0 counts for the time without contact
  double slip = 0;         ///< length of its way, mm
  double dissipated = 0;   ///< N mm
};

/// The depth that slip wears off the base of the body: in proportion to pressure times slip (Archard, J.
/// Appl. Phys. 24, 1953, 981), or to dissipated energy per area (Fouvry et al., Wear 255, 2003, 287).
/// docs/theory.md, section 3, "Wear".
class WearLaw
{
public:
  /// A law without wear.
  WearLaw() = default;

  /// The law of the options, with the areas of the nodes of `surface`.
  WearLaw(const WearOptions &options, const ContactSurface &surface);

  /// Depth that a node (index in the model) loses, mm.
  double depth(Eigen::Index node, const Rubbing &rubbing) const;

  const WearOptions &options() const { return options_; }

private:
  WearOptions options_{};
  Eigen::VectorXd areas_{}; ///< of the nodes, mm^2
};
} // namespace orthocone
