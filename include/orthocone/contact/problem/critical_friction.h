// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_system.h>

#include <limits>

namespace orthocone
{
/// How close a problem is to friction so strong that a load step may have several solutions.
struct CriticalFriction
{
  /// A node can wedge once all coefficients are multiplied by this. It is infinite where no normal force
  /// couples with tangential displacements, 0 where the slip rule alone is enough, whatever the coefficients,
  /// and not a number where the compliance of single nodes is not known, or a law is no ellipse.
  double factor = std::numeric_limits<double>::infinity();
  Eigen::Index node = 0; ///< the node with the least factor
};

/// The factor by which friction at a node may grow before the node has, under some load, a stuck solution
/// besides a slipping or an open one while the forces of all others stay as they are. `block` is the node's 3
/// x 3 block of W (mm/N), K its inverse. The normal force lost in a slip v_t must not outweigh the friction
/// that resists it (docs/theory.md, section 8):
///
///   factor = min over v_t of  v_t . Q^2 K_tt v_t / (||Q^2 v_t||*_m |K_nt . v_t|),
///
/// In a plane problem with isotropic friction this is K_tt / (mu |K_nt|) = w_nn / (mu |w_nt|). A direction
/// that is coupled with no other one within the block is taken to be held. A law that is no ellipse has no
/// such formula, and no number. Throws nothing.
double critical_friction_factor(const FrictionLaw &law, const Eigen::Matrix3d &block);

/// The least factor of all nodes. For the whole problem it is an estimate and bounds nothing, since other
/// nodes answer to a slip. It costs a few operations a node.
CriticalFriction critical_friction(const ContactSystem &system);
} // namespace orthocone
