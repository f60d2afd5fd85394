// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

namespace orthocone
{
/// A map that vanishes at the solution, linearized at given unknowns: the conditions of every node and of the
/// face for Newton's method.
struct Linearization
{
  ContactConditions conditions;
  double error; ///< norm of the map, N
};

/// The natural map (ContactStep::natural_map(), TrialForce). `displacement` belongs to `unknowns`; the map
/// has `rho_factor` times the rho of the system.
Linearization linearize(const ContactStep &step, const Eigen::VectorXd &unknowns,
                        const NodeVector &displacement, double rho_factor = 1);

/// For laws that are ellipses, another map of the same zeros: r less the nearest point of the elliptic cone
/// to r - rho G(d), with the modified displacement G of elliptic_cone.h. It asks for the whole force of a
/// node at once. Its slopes are not those of the natural map, so that Newton's method stalls elsewhere.
Linearization linearize_on_elliptic_cone(const ContactStep &step, const Eigen::VectorXd &unknowns,
                                         const NodeVector &displacement, double rho_factor = 1);

/// Forces and motion of the face of a change, in the order of the unknowns of a step.
Eigen::VectorXd unknowns_of(const ContactChange &change);

/// A change with the displacement that it causes, which a solver with a dense compliance leaves to others.
ContactChange with_displacement(const ContactStep &step, ContactChange change);

/// Newton's change of the unknowns, up to a relative error `accuracy` or the best that can be reached. Not
/// finite if the linearization is singular.
Eigen::VectorXd newton_change(const ConditionSolver &solver, const Linearization &linearization,
                              double accuracy);
} // namespace orthocone
