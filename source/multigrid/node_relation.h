// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/condition_solver.h>
#include <orthocone/surface/contact_surface.h>

namespace orthocone
{
/// The directions of a node that contact holds.
enum class Hold : unsigned char
{
  nothing, ///< its force is given
  normal,  ///< u_z follows u_x and u_y, which friction resists
  all,     ///< its displacement is given
};

/// A NodeCondition for the whole body, in global axes. With the tangential part t = (x, y) of the change of
/// displacement u and of the change of force f:
///   nothing: f = force
///   normal:  u_z = displacement_z - follows . u_t,  f_t + coupling f_z + robin u_t = force_t
///   all:     u = displacement
/// All operators with contact have these equations: on vectors (relation_rows.h) on the body and on levels,
/// as rows of a sparse matrix (NodeStiffness), and of a dense one (FactorizedCoarse).
struct NodeRelation
{
  Hold hold = Hold::nothing;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();        ///< N
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero(); ///< mm
  Eigen::Vector2d follows = Eigen::Vector2d::Zero();
  Eigen::Vector2d coupling = Eigen::Vector2d::Zero();
  Eigen::Matrix2d robin = Eigen::Matrix2d::Zero(); ///< N/mm

  /// Whether a direction of the node is held, or friction resists in it. Else its force is given.
  bool holds(const unsigned int direction) const
  {
    return hold == Hold::all || (hold == Hold::normal && direction == 2);
  }
  bool resists(const unsigned int direction) const { return hold == Hold::normal && direction < 2; }
};

/// The relation of a condition. `global_in_local` is LocalAxes::global_in_local() of the node. Directions
/// that symmetry holds drop out.
NodeRelation relation_of(const NodeCondition &condition, const Eigen::Matrix3d &global_in_local,
                         const ContactNode &node);

/// The relation's `robin`, bounded at nodes whose directions are as stiff as `stiffness` (N/mm): more than
/// 10^4 times that is as good as held, and too much for preconditioners in single precision.
Eigen::Matrix2d bounded_robin(const NodeRelation &relation, double stiffness);
} // namespace orthocone
