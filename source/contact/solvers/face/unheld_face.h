// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

namespace orthocone
{
/// Whether forces drive a face that no node holds yet: then no force depends on how the face moves, and
/// Newton's method cannot start.
bool is_unheld_without_forces(const ContactStep &step, const Eigen::VectorXd &unknowns);

/// Contact forces that carry what drives the face, as evenly as they can.
Eigen::VectorXd balancing_start(const ContactStep &step);

/// The increment (size m, mm) by which a face that the closed nodes of the law linearized at `unknowns` do
/// not hold follows its load. It ends where the nodes that it meets carry the load's normal part, each of
/// them as a spring of stiffness rho, which is `rho_factor` times that of the system. Newton's system is
/// singular without it: that is so where wear has left no contact, or too few nodes for a face that may tilt.
/// `displacement` belongs to `unknowns`. No numbers where the face is held, or meets no node.
Eigen::VectorXd increment_of_unheld_face(const ContactStep &step, const Eigen::VectorXd &unknowns,
                                         const NodeVector &displacement, const ContactConditions &conditions,
                                         double rho_factor);
} // namespace orthocone
