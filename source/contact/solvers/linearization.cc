// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "linearization.h"

#include <cmath>

namespace orthocone
{
namespace
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// An open node has no unknowns, a stuck one three, a slipping one two, along and across the generator of the
/// cone: the linearization fixes its third component.
NodeCondition condition_of(const OrthotropicFriction &law, const double rho, const Projection &projection,
                           const Vector3d &map, const Vector3d &displacement)
{
  NodeCondition condition;
  if (projection.zone == ConeZone::polar)
  {
    condition.fixed = -map;
    return condition;
  }
  const Matrix3d slope = rho * modified_displacement_derivative(law, displacement);
  if (projection.zone == ConeZone::inside)
  {
    condition.n_unknowns = 3;
    condition.basis.setIdentity();
    condition.rows = slope.transpose();
    condition.right_side = -map;
    return condition;
  }
  // I - P = normal normal^T + (1 - stiffness) side side^T: the part along `normal` is decoupled.
  condition.n_unknowns = 2;
  condition.basis.leftCols<2>() << projection.ray, projection.side;
  condition.rows.leftCols<2>() << slope.transpose() * projection.ray,
      projection.stiffness * slope.transpose() * projection.side;
  condition.diagonal[1] = 1 - projection.stiffness;
  condition.right_side.head<2>() << -projection.ray.dot(map), -projection.side.dot(map);
  condition.fixed = -projection.normal.dot(map) * projection.normal;
  return condition;
}
} // namespace

Linearization linearize(const ContactStep &step, const VectorXd &unknowns, const NodeVector &displacement,
                        const double rho_factor)
{
  Linearization result;
  result.conditions.nodes.reserve(step.n_nodes());
  result.conditions.face = step.face().columns();
  result.conditions.face_right_side = -step.imbalance(unknowns);
  double sum = result.conditions.face_right_side.squaredNorm();
  for (Index node = 0; node < step.n_nodes(); ++node)
  {
    const OrthotropicFriction &law = step.law(node);
    const double rho = rho_factor * step.system().rho(node);
    const Vector3d force = unknowns.segment<3>(3 * node);
    const Vector3d d = displacement.segment<3>(3 * node);
    const Projection projection =
        ContactStep::is_free(force, d)
            ? Projection()
            : project_with_derivative(law, force - rho * modified_displacement(law, d));
    const Vector3d map = force - projection.point;
    sum += map.squaredNorm();
    result.conditions.nodes.push_back(condition_of(law, rho, projection, map, d));
  }
  result.error = std::sqrt(sum);
  return result;
}

VectorXd newton_change(const ConditionSolver &solver, const Linearization &linearization,
                       const double accuracy)
{
  const ContactChange change = solver.solve(linearization.conditions, accuracy);
  VectorXd unknowns(change.force.size() + change.face.size());
  unknowns << change.force, change.face;
  return unknowns;
}
} // namespace orthocone
