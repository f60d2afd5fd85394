// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "linearization.h"

#include <orthocone/contact/law/natural_map.h>

#include <cmath>

namespace orthocone
{
namespace
{
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A node's part of the map: its linearization, and its value where it is not 0.
struct NodePart
{
  NodeCondition condition;
  Vector3d value; ///< N
};

/// A node that slips under the normal force N. Its reduced force obeys r' = N y/|y| with y = r' - rho g. With
/// e = y/|y|, e' across it and dr_t = (d r_t / d r') dr', Newton's step is dr' = (dr_n + r_n - e.r') e + c e'
/// and (1 - s) c + s rho e'.dg = -e'.r' with s = N/|y|: two unknowns, along the generator of the cone and
/// across it.
NodePart slipping_part(const FrictionLaw &law, const double rho, const TrialForce &trial,
                       const Vector3d &force, const Vector3d &displacement)
{
  const Vector2d along = trial.reduced / trial.length;
  const Vector2d across(-along[1], along[0]);
  const double softening = trial.normal / trial.length; // of friction across its direction, below 1
  const Vector2d reduced = law.reduced_force(force.tail<2>());
  const Eigen::Matrix2d slopes = law.force_derivative(force.tail<2>());
  const Vector2d ray = slopes * along, side = slopes * across;
  NodePart part;
  NodeCondition &condition = part.condition;
  condition.n_unknowns = 2;
  condition.basis.col(0) << 1, ray;
  condition.basis.col(0).normalize();
  condition.basis.col(1).tail<2>() = side.normalized();
  condition.rows(0, 0) = rho;
  condition.rows.col(1).tail<2>() = side.norm() * softening * rho *
                                    law.reduced_slip_derivative(displacement.tail<2>()).transpose() * across;
  condition.diagonal[1] = 1 - softening;
  condition.right_side.head<2>() << -rho * displacement[0], -side.norm() * across.dot(reduced);
  condition.fixed.tail<2>() = (force[0] - along.dot(reduced)) * ray;
  part.value << rho * displacement[0], force.tail<2>() - law.force(trial.normal * along);
  return part;
}

/// A node that sticks. Its displacement counts as much as that of a node about to stick does: else the map
/// would jump where a node changes its status, and no line search could cross the jump.
NodePart sticking_part(const FrictionLaw &law, const double rho, const TrialForce &trial,
                       const Vector3d &force, const Vector3d &displacement)
{
  const Eigen::Matrix2d slopes = law.force_derivative(force.tail<2>());
  const Vector2d slip = displacement.tail<2>();
  NodePart part;
  part.value << rho * displacement[0], force.tail<2>() - law.force(trial.reduced);
  part.condition.n_unknowns = 3;
  part.condition.basis.setIdentity();
  part.condition.rows(0, 0) = rho;
  part.condition.rows.bottomRightCorner<2, 2>() =
      rho * (slopes * law.reduced_slip_derivative(slip)).transpose();
  part.condition.right_side << -rho * displacement[0], -rho * slopes * law.reduced_slip(slip);
  return part;
}

/// A node without friction: its tangential force is to vanish.
NodePart frictionless_part(const double rho, const Vector3d &force, const Vector3d &displacement)
{
  NodePart part;
  part.value << rho * displacement[0], force.tail<2>();
  part.condition.n_unknowns = 2;
  part.condition.basis.leftCols<2>().setIdentity();
  part.condition.rows(0, 0) = rho;
  part.condition.diagonal[1] = 1;
  part.condition.right_side.head<2>() << -rho * displacement[0], -force[1];
  part.condition.fixed[2] = -force[2];
  return part;
}

NodePart natural_part(const FrictionLaw &law, const double rho, const Vector3d &force,
                      const Vector3d &displacement)
{
  const TrialForce trial(law, rho, force, displacement);
  if (trial.is_open())
  {
    NodePart part;
    part.condition.fixed = -force;
    part.value = force;
    return part;
  }
  if (law.is_frictionless())
    return frictionless_part(rho, force, displacement);
  return trial.sticks() ? sticking_part(law, rho, trial, force, displacement)
                        : slipping_part(law, rho, trial, force, displacement);
}
/// A node's part of the map on the elliptic cone. An open node has no unknowns, a stuck one three, a slipping
/// one two, along and across the generator of the cone: the linearization fixes its third component, since
/// I - P = normal normal^T + (1 - stiffness) side side^T for the derivative P of the projection. A node
/// without force that does not penetrate obeys the law, whatever rounding makes of its slip.
NodePart elliptic_part(const FrictionLaw &law, const double rho, const Vector3d &force,
                       const Vector3d &displacement)
{
  const OrthotropicFriction ellipse = normalized(*law.ellipse());
  const bool is_free = force.isZero(0) && displacement[0] >= 0;
  const Projection projection =
      is_free ? Projection()
              : project_with_derivative(ellipse, force - rho * modified_displacement(ellipse, displacement));
  NodePart part;
  NodeCondition &condition = part.condition;
  part.value = force - projection.point;
  condition.n_unknowns = projection.n_directions();
  condition.fixed = -part.value;
  if (condition.n_unknowns == 0)
    return part;
  const Eigen::Matrix3d slope = rho * modified_displacement_derivative(ellipse, displacement);
  if (condition.n_unknowns == 3)
  {
    condition.basis.setIdentity();
    condition.rows = slope.transpose();
    condition.right_side = -part.value;
    condition.fixed.setZero();
    return part;
  }
  condition.basis.leftCols<2>() << projection.ray, projection.side;
  condition.rows.leftCols<2>() << slope.transpose() * projection.ray,
      projection.stiffness * slope.transpose() * projection.side;
  condition.diagonal[1] = 1 - projection.stiffness;
  condition.right_side.head<2>() << -projection.ray.dot(part.value), -projection.side.dot(part.value);
  condition.fixed = -projection.normal.dot(part.value) * projection.normal;
  return part;
}

template<typename Part>
Linearization linearize_with(const Part &part_of_node, const ContactStep &step, const VectorXd &unknowns,
                             const NodeVector &displacement, const double rho_factor)
{
  Linearization result;
  result.conditions.nodes.reserve(step.n_nodes());
  result.conditions.face = step.face().columns();
  result.conditions.face_right_side = -step.imbalance(unknowns);
  result.conditions.face_stiffness = step.face().stiffness();
  double sum = result.conditions.face_right_side.squaredNorm();
  for (Index node = 0; node < step.n_nodes(); ++node)
  {
    const NodePart part = part_of_node(step.law(node), rho_factor * step.system().rho(node),
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

Linearization linearize_on_elliptic_cone(const ContactStep &step, const VectorXd &unknowns,
                                         const NodeVector &displacement, const double rho_factor)
{
  return linearize_with(elliptic_part, step, unknowns, displacement, rho_factor);
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
