// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>
#include <orthocone/surface/contact_surface.h>

#include <Eigen/Core>

namespace orthocone
{
/// Areas of the contact nodes, mm^2.
Eigen::VectorXd areas_of(const ContactSurface &surface);

/// What a node does on its way along the obstacle in one solved step.
struct Rubbing
{
  double normal_force = 0; ///< mean over the step, N; nothing for the time without contact
  double slip = 0;         ///< length of its way, mm
  double dissipated = 0;   ///< N mm
};

/// How deep slip wears the base of the body: by pressure times slip (Archard, J. Appl. Phys. 24, 1953, 981),
/// or by dissipated energy per area (Fouvry et al., Wear 255, 2003, 287). The rates are explicit: a step
/// finds the surface that the steps before it have left, and its own wear is found by the next one.
class WearLaw
{
public:
  /// Nothing wears.
  WearLaw() = default;

  WearLaw(const WearOptions &options, const ContactSurface &surface);

  /// Depth that a node (index in the model) loses, mm.
  double depth(Eigen::Index node, const Rubbing &rubbing) const;

private:
  WearOptions options_{};
  Eigen::VectorXd areas_{}; ///< of the nodes, mm^2
};
} // namespace orthocone
