// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "exact_nodes.h"

#include "../newton/linearization.h"
#include "ladder.h"
#include "worst_nodes.h"

#include <orthocone/contact/law/one_node.h>
#include <orthocone/surface/exact_compliance.h>

#include <utility>

namespace orthocone
{

namespace
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The conditions of changes that are due to one force, and to nothing else. `nodes` take no other forces.
ContactConditions conditions_of_force(ContactConditions conditions, const std::vector<Index> &nodes, const Index node,
                                      const Vector3d &force)
{
  for (NodeCondition &other : conditions.nodes)
  {
    other.right_side.setZero();
    other.fixed.setZero();
  }
  for (const Index free : nodes)
    conditions.nodes[free] = NodeCondition();
  conditions.nodes[node].fixed = force;
  conditions.face_right_side.setZero();
  conditions.residual.setZero();
  return conditions;
}

void add(ContactChange &change, const double factor, const ContactChange &other)
{
  change.force += factor * other.force;
  change.face += factor * other.face;
  change.displacement += factor * other.displacement;
  change.body =
      change.body.moved(1, BodyPart{factor * other.body.displacement, factor * other.body.residual});
}

/// Forces of one node (all directions of slip are tried) or of several, from `start` on. `free` is their
/// displacement without forces (mm).
std::optional<VectorXd> exact_forces(const ContactStep &step, const std::vector<Index> &nodes, const MatrixXd &compliance,
                                     const VectorXd &free, const VectorXd &start)
{
  if (nodes.size() == 1)
  {
    const Matrix3d stiffness = compliance.inverse();
    if (!stiffness.allFinite())
      return std::nullopt;
    return solve_one_node(step.law(nodes[0]), {compliance, stiffness}, free, start);
  }
  FrictionLaws laws;
  for (const Index node : nodes)
    laws.push_back(step.law(node));
  const UnsymmetricCompliance few(compliance);
  const ContactSystem system(few, std::move(laws));
  VectorXd forces = start;
  if (!make_whole_body_newton(system, {})->solve(ContactStep(system, free), forces).converged)
    return std::nullopt;
  return forces;
}
} // namespace

/// Where all other nodes obey their linearized conditions, the chosen ones have the displacement
///   d = d_free + S r,
/// with their forces r and the Schur complement S of the conditions of the others, which need not be
/// symmetric. Column 3 k + i of S is the displacement under a unit force in direction i of node k. With S the
/// chosen nodes are a contact problem of their own. The change that belongs to its forces is the sum of the
/// columns' changes, so that the others still obey their conditions.
std::optional<ContactChange> with_exact_nodes(const ContactStep &step, const VectorXd &unknowns,
                                              const NodeVector &displacement,
                                              const ContactConditions &conditions,
                                              const ConditionSolver &solver, ContactChange change,
                                              const std::vector<Index> &nodes)
{
  constexpr double accuracy = 1e-2; // Newton's next steps mend what it leaves
  const std::vector<Index> entries = entries_of(nodes);
  const auto n = static_cast<Index>(entries.size());
  std::vector<ContactChange> of_force;
  MatrixXd compliance(n, n);
  for (const Index node : nodes)
    for (int i = 0; i < 3; ++i)
    {
      of_force.push_back(with_displacement(
          step, solver.solve(conditions_of_force(conditions, nodes, node, Vector3d::Unit(i)), accuracy)));
      compliance.col(static_cast<Index>(of_force.size()) - 1) = of_force.back().displacement(entries);
    }
  const VectorXd moved = unknowns(entries) + change.force(entries);
  const VectorXd free = displacement(entries) + change.displacement(entries) - compliance * moved;
  const VectorXd start = nodes.size() == 1 ? moved : VectorXd(unknowns(entries));
  const auto forces = exact_forces(step, nodes, compliance, free, start);
  if (!forces || !forces->allFinite())
    return std::nullopt;
  for (Index i = 0; i < n; ++i)
    add(change, (*forces)[i] - moved[i], of_force[i]);
  return change;
}
} // namespace orthocone
