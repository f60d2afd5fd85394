// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "node_relation.h"

#include <algorithm>

namespace orthocone
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

/// A node that slips has two unknowns, x_0 along the generator of the cone and x_1 across it; the third
/// direction of the force is fixed. Its two equations, linearized by Newton's method, are
///   along . u = right_side_0   and   across . u + softness x_1 = right_side_1:
/// the cone gives way across the ray only. With x_0 along the ray and
/// x_1 across it, f = fixed + ray x_0 + side x_1. The first equation gives u_z, the second one x_1. x_0 is
/// the reaction of the plane, and drops out of f_t + coupling f_z.
NodeRelation mixed_relation(const NodeCondition &condition, const Eigen::Matrix3d &global_in_local)
{
  constexpr double least_softness = 1e-9; // of the natural map across the ray, relative to 1
  const Vector3d ray = global_in_local * condition.basis.col(0),
                 side = global_in_local * condition.basis.col(1);
  const Vector3d along = global_in_local * condition.rows.col(0);
  const Vector3d across = global_in_local * condition.rows.col(1);
  const Vector3d fixed = global_in_local * condition.fixed;
  const double softness = std::max(condition.diagonal[1], least_softness);
  NodeRelation relation;
  relation.hold = Hold::normal;
  relation.displacement[2] = condition.right_side[0] / along[2];
  relation.follows = along.head<2>() / along[2];
  relation.coupling = -ray.head<2>() / ray[2];
  const Vector2d push = (side.head<2>() + relation.coupling * side[2]) / softness;
  relation.robin = push * (across.head<2>() - across[2] * relation.follows).transpose();
  relation.force.head<2>() = fixed.head<2>() + relation.coupling * fixed[2] +
                             push * (condition.right_side[1] - across[2] * relation.displacement[2]);
  return relation;
}
} // namespace

NodeRelation relation_of(const NodeCondition &condition, const Eigen::Matrix3d &global_in_local,
                         const ContactNode &node)
{
  NodeRelation relation;
  if (condition.n_unknowns == 0)
    relation.force = global_in_local * condition.fixed;
  else if (condition.n_unknowns == 3)
  {
    relation.hold = Hold::all;
    relation.displacement = global_in_local * (condition.rows.transpose().inverse() * condition.right_side);
  }
  else
    relation = mixed_relation(condition, global_in_local);
  for (unsigned int d = 0; d < 2; ++d)
    if (!node.is_free[d])
    {
      relation.force[d] = relation.displacement[d] = relation.follows[d] = relation.coupling[d] = 0;
      relation.robin.row(d).setZero();
      relation.robin.col(d).setZero();
    }
  return relation;
}

// A level in single precision must not add numbers to K that leave none of its digits: next to 10^7 times the
// stiffness the body would vanish. A bounded one holds the node nearly as well, and only preconditions.
Eigen::Matrix2d bounded_robin(const NodeRelation &relation, const double stiffness)
{
  constexpr double most = 1e4; // single precision has seven digits
  const double size = relation.robin.cwiseAbs().maxCoeff();
  return size <= most * stiffness ? relation.robin : most * stiffness / size * relation.robin;
}
} // namespace orthocone
