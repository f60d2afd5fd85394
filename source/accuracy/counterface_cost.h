// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>

namespace orthocone
{
/// What an elastic half-space adds to a body with multigrid. All is zero on a rigid counterface.
struct CounterfaceCost
{
  double gigabytes = 0, set_up_seconds = 0;
  double cycle_seconds = 0; ///< of each V-cycle
};

/// `n_contact_nodes` are those of the finest mesh.
CounterfaceCost counterface_cost(const ObstacleOptions &obstacle, double n_contact_nodes);
} // namespace orthocone
