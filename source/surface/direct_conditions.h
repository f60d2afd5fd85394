// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>

#include <optional>

namespace orthocone
{
/// Solves conditions of contact nodes on a dense compliance by elimination. `softness` (mm/N): the largest
/// eigenvalue of W. Nothing where there is no unknown, where the system is singular, or where it has so many
/// unknowns that GMRES is faster (docs/performance.md).
std::optional<ContactChange> solve_directly(const ContactConditions &conditions, const DenseView &compliance,
                                            double softness);

/// The same, however many unknowns there are.
std::optional<ContactChange> eliminate(const ContactConditions &conditions, const DenseView &compliance,
                                       double softness);

/// The same on a compliance that need not be symmetric, and with whatever a system close to singular gives.
/// Without unknowns the forces are those that are given; they are no numbers where the system has none.
ContactChange eliminate_whatever_it_gives(const ContactConditions &conditions, const DenseView &compliance,
                                          double softness);

/// How the face moves under given contact forces (3 n): as far as its own stiffness lets it, or not at all
/// where it has none.
Eigen::VectorXd face_alone(const ContactConditions &conditions, const NodeVector &force);
} // namespace orthocone
