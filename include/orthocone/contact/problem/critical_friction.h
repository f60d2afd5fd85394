// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_system.h>

#include <limits>

namespace orthocone
{
/// How near a problem is to friction so strong that a load step may have several solutions.
struct CriticalFriction
{
  /// All coefficients may be multiplied by less than this before a node can wedge; infinite where no normal
  /// force couples with tangential displacements, 0 where the slip rule alone is enough, whatever the
  /// coefficients; not a number where the compliance of single nodes is not known.
  double factor = std::numeric_limits<double>::infinity();
  Eigen::Index node = 0; ///< where it is least
};

/// The factor by which friction at a node may grow before it has, under some load, a stuck solution besides a
/// slipping or an open one while the forces of all others stay as they are. With K the inverse of the block
/// of W, the normal force lost in a slip v_t must not outweigh the friction that resists it:
///
///   factor = min over v_t of  v_t . Q^2 K_tt v_t / (||Q^2 v_t||*_m |K_nt . v_t|),
///
/// for a plane problem with isotropic friction K_tt / (mu |K_nt|) = w_nn / (mu |w_nt|). A direction that is
/// coupled with no other one within the block is taken for one that is held.
double critical_friction_factor(const OrthotropicFriction &law, const Eigen::Matrix3d &block);

/// The least factor of all nodes: an estimate for the whole problem, neither a bound from above nor from
/// below, since other nodes answer to a slip. Costs a few operations a node.
CriticalFriction critical_friction(const ContactSystem &system);
} // namespace orthocone
