// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "exact_node.h"

#include "linearization.h"

#include <orthocone/contact/law/one_node.h>

#include <array>

namespace orthocone
{
namespace
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The conditions of changes that are due to one force, and to nothing else.
ContactConditions conditions_of_force(ContactConditions conditions, const Index node, const Vector3d &force)
{
  for (NodeCondition &other : conditions.nodes)
  {
    other.right_side.setZero();
    other.fixed.setZero();
  }
  conditions.nodes[node] = NodeCondition();
  conditions.nodes[node].fixed = force;
  conditions.face_right_side.setZero();
  conditions.rest.setZero();
  return conditions;
}

void add(ContactChange &change, const double factor, const ContactChange &other)
{
  change.force += factor * other.force;
  change.face += factor * other.face;
  change.displacement += factor * other.displacement;
  change.body = change.body.moved(1, BodyPart{factor * other.body.displacement, factor * other.body.rest});
}
} // namespace

ContactChange with_displacement(const ContactStep &step, ContactChange change)
{
  if (change.displacement.size() > 0)
    return change;
  change.displacement = step.change_of_displacement(unknowns_of(change));
  return change;
}

std::optional<Index> hardest_node(const ContactStep &step, const VectorXd &unknowns,
                                  const NodeVector &displacement)
{
  constexpr double least_share = 0.9;
  const VectorXd map = step.natural_map(unknowns, displacement);
  Index hardest = 0;
  double largest = 0;
  for (Index node = 0; node < step.n_nodes(); ++node)
    if (const double square = map.segment<3>(3 * node).squaredNorm(); square > largest)
    {
      hardest = node;
      largest = square;
    }
  return largest >= least_share * map.squaredNorm() ? std::optional(hardest) : std::nullopt;
}

std::optional<ContactChange> with_exact_node(const ContactStep &step, const VectorXd &unknowns,
                                             const NodeVector &displacement,
                                             const ContactConditions &conditions,
                                             const ConditionSolver &solver, ContactChange change,
                                             const Index node)
{
  constexpr double accuracy = 1e-2; // Newton's next steps mend what it leaves
  const Index place = 3 * node;
  std::array<ContactChange, 3> of_force;
  Matrix3d compliance;
  for (int i = 0; i < 3; ++i)
  {
    of_force[i] = with_displacement(
        step, solver.solve(conditions_of_force(conditions, node, Vector3d::Unit(i)), accuracy));
    compliance.col(i) = of_force[i].displacement.segment<3>(place);
  }
  const Matrix3d stiffness = compliance.inverse();
  if (!stiffness.allFinite())
    return std::nullopt;
  const Vector3d moved = unknowns.segment<3>(place) + change.force.segment<3>(place);
  const Vector3d free =
      displacement.segment<3>(place) + change.displacement.segment<3>(place) - compliance * moved;
  const Vector3d force = solve_one_node({step.law(node), compliance, stiffness}, free, moved);
  if (!force.allFinite())
    return std::nullopt;
  for (int i = 0; i < 3; ++i)
    add(change, force[i] - moved[i], of_force[i]);
  return change;
}
} // namespace orthocone
