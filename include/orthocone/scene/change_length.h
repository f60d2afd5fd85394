// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/friction_field.h>
#include <orthocone/scene/obstacle.h>

namespace orthocone
{
/// Length (mm, one a node) over which gap or friction change at each contact node: their range over the whole
/// surface divided by their slope there; infinite where they are constant, never zero. Gap and friction are
/// taken at the reference position of the nodes, which is right for slips that are small against this length
/// (docs/theory.md, section 3, "Gaps and friction that varies").
Eigen::VectorXd change_lengths(const Obstacle &obstacle, const FrictionField &friction,
                               const ContactSurface &surface, const LocalAxes &axes);
} // namespace orthocone
