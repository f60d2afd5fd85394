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
using Eigen::Vector2d;
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

/// A node's part of a map: its linearization, and its value where it is not 0.
struct NodePart
{
  NodeCondition condition;
  Vector3d value; ///< N
};

NodePart natural_part(const OrthotropicFriction &law, const double rho, const Vector3d &force,
                      const Vector3d &displacement)
{
  const Projection projection =
      ContactStep::is_free(force, displacement)
          ? Projection()
          : project_with_derivative(law, force - rho * modified_displacement(law, displacement));
  const Vector3d map = force - projection.point;
  return {condition_of(law, rho, projection, map, displacement), map};
}

/// A node that slips under the pressure `pressure` (N). Forces are relative to mu, so that the cone is
/// circular: s = r_t / mu, and the slip that counts is w = mu Q^2 d_t. The law is then s = pressure y / |y|
/// with y = s - rho_t w.
NodePart slipping_part(const OrthotropicFriction &law, const double rho, const double rho_t,
                       const double pressure, const Vector3d &force, const Vector3d &displacement,
                       const Vector2d &y)
{
  const Vector2d mu(law.mu_x, law.mu_y);
  const Vector2d s = force.tail<2>().cwiseQuotient(mu);
  const Vector2d along = y.normalized();
  const Vector2d across(-along[1], along[0]);
  const double softening = pressure / y.norm(); // of friction across its direction, below 1
  const Vector2d side = mu.cwiseProduct(across);
  NodePart part;
  NodeCondition &condition = part.condition;
  condition.n_unknowns = 2;
  condition.basis.col(0) << 1, mu.cwiseProduct(along);
  condition.basis.col(0).normalize();
  condition.basis.col(1).tail<2>() = side.normalized();
  condition.rows(0, 0) = rho;
  condition.rows.col(1).tail<2>() = side.norm() * softening * rho_t * slip_weights(law).cwiseProduct(side);
  condition.diagonal[1] = 1 - softening;
  condition.right_side.head<2>() << -rho * displacement[0], -side.norm() * across.dot(s);
  condition.fixed.tail<2>() = (force[0] - along.dot(s)) * mu.cwiseProduct(along);
  part.value << rho * displacement[0], mu.cwiseProduct(s - pressure * along);
  return part;
}

/// A node that sticks. Its displacement counts as much as that of a node about to stick does: else the map
/// would jump where a node changes its status, and no line search could cross the jump.
NodePart sticking_part(const double rho, const Vector2d &tangential_weights, const Vector3d &displacement)
{
  const Vector3d weights(rho, tangential_weights[0], tangential_weights[1]);
  NodePart part;
  part.value = weights.cwiseProduct(displacement);
  part.condition.n_unknowns = 3;
  part.condition.basis.setIdentity();
  part.condition.rows = weights.asDiagonal();
  part.condition.right_side = -part.value;
  return part;
}

NodePart alart_curnier_part(const OrthotropicFriction &law, const double rho, const Vector3d &force,
                            const Vector3d &displacement)
{
  if (is_frictionless(law))
    return natural_part(law, rho, force, displacement);
  const double pressure = force[0] - rho * displacement[0];
  if (pressure <= 0)
  {
    NodePart part;
    part.condition.fixed = -force;
    part.value = force;
    return part;
  }
  const Vector2d mu(law.mu_x, law.mu_y);
  const Vector2d weights = slip_weights(law).cwiseProduct(mu);
  const double rho_t = rho / weights.cwiseProduct(mu).maxCoeff();
  const Vector2d y = force.tail<2>().cwiseQuotient(mu) - rho_t * weights.cwiseProduct(displacement.tail<2>());
  if (y.norm() > pressure)
    return slipping_part(law, rho, rho_t, pressure, force, displacement, y);
  return sticking_part(rho, rho_t * mu.cwiseProduct(weights), displacement);
}

template<typename Part>
Linearization linearize_with(const Part &part_of, const ContactStep &step, const VectorXd &unknowns,
                             const NodeVector &displacement, const double rho_factor)
{
  Linearization result;
  result.conditions.nodes.reserve(step.n_nodes());
  result.conditions.face = step.face().columns();
  result.conditions.face_right_side = -step.imbalance(unknowns);
  double sum = result.conditions.face_right_side.squaredNorm();
  for (Index node = 0; node < step.n_nodes(); ++node)
  {
    const NodePart part = part_of(step.law(node), rho_factor * step.system().rho(node),
                                  unknowns.segment<3>(3 * node), displacement.segment<3>(3 * node));
    sum += part.value.squaredNorm();
    result.conditions.nodes.push_back(part.condition);
  }
  result.error = std::sqrt(sum);
  return result;
}
} // namespace

Linearization linearize(const ContactStep &step, const VectorXd &unknowns, const NodeVector &displacement,
                        const double rho_factor)
{
  return linearize_with(natural_part, step, unknowns, displacement, rho_factor);
}

Linearization linearize_alart_curnier(const ContactStep &step, const VectorXd &unknowns,
                                      const NodeVector &displacement, const double rho_factor)
{
  return linearize_with(alart_curnier_part, step, unknowns, displacement, rho_factor);
}

VectorXd unknowns_of(const ContactChange &change)
{
  VectorXd unknowns(change.force.size() + change.face.size());
  unknowns << change.force, change.face;
  return unknowns;
}

ContactChange with_displacement(const ContactStep &step, ContactChange change)
{
  if (change.displacement.size() == 0)
    change.displacement = step.change_of_displacement(unknowns_of(change));
  return change;
}

VectorXd newton_change(const ConditionSolver &solver, const Linearization &linearization,
                       const double accuracy)
{
  return unknowns_of(solver.solve(linearization.conditions, accuracy));
}
} // namespace orthocone
