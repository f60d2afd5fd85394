// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

namespace orthocone
{
/// Whether forces drive the face and all nodes are open: no force depends on how the face moves, so that
/// Newton's system is singular. So it is where a step has worn off more than pressure flattens the body.
bool is_loose(const ContactConditions &conditions);

/// How far a loose face must follow its load (size m, mm) until the nodes carry the load's normal part, each
/// of them as a spring of stiffness 1 / rho: Newton's method can start from there. `displacement` belongs to
/// `unknowns`; rho is `rho_factor` times that of the system. Zero where the load presses no node.
Eigen::VectorXd way_to_touch(const ContactStep &step, const Eigen::VectorXd &unknowns,
                             const NodeVector &displacement, double rho_factor);
} // namespace orthocone
