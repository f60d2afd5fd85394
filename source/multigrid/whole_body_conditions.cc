// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "whole_body_conditions.h"

#include "held_stiffness.h"
#include "node_values.h"

#include <orthocone/base/ranks.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

ContactChange contact_change(const ContactFrame &frame, const BodyVector<double> &displacement,
                             const BodyVector<double> &forces, const VectorXd &residual)
{
  const auto n = static_cast<Index>(frame.n_free());
  ContactChange change;
  change.body = {entries(displacement, n),
                 residual.size() == 0 ? VectorXd(VectorXd::Zero(n)) : VectorXd(-residual)};
  // First this is K u less the forces that the body lacks already; then the contact forces are taken out.
  VectorXd &left = change.body.residual;
  left += entries(forces, n);
  change.force.setZero(3 * frame.nodes().size());
  change.displacement.setZero(change.force.size());
  for (std::size_t i = 0; i < frame.nodes().size(); ++i)
  {
    if (!frame.nodes()[i].is_here())
      continue;
    Vector3d force = Vector3d::Zero(), moved = Vector3d::Zero();
    for (unsigned int d = 0; d < 3; ++d)
      if (frame.nodes()[i].is_free[d])
      {
        const unsigned int dof = frame.nodes()[i].dofs[d];
        std::swap(force[d], left[dof]);
        moved[d] = displacement.local_element(dof);
      }
    const auto place = 3 * static_cast<Index>(i);
    change.force.segment<3>(place) = frame.global_in_local(i).transpose() * force;
    change.displacement.segment<3>(place) = frame.global_in_local(i).transpose() * moved;
  }
  sum_over_ranks(change.force.data(), static_cast<std::size_t>(change.force.size()));
  sum_over_ranks(change.displacement.data(), static_cast<std::size_t>(change.displacement.size()));
  left *= -1;
  if (residual.size() > 0)
    left -= residual;
  return change;
}

WholeBodyConditions::WholeBodyConditions(const ContactFrame &frame,
                                         const MatrixFreeStiffness<double> &stiffness, VCycle &cycle)
    : frame_(frame),
      stiffness_(stiffness),
      cycle_(cycle)
{
}

std::vector<NodeRelation>
WholeBodyConditions::relations_of(const std::vector<NodeCondition> &conditions) const
{
  std::vector<NodeRelation> relations;
  for (std::size_t i = 0; i < conditions.size(); ++i)
    relations.push_back(relation_of(conditions[i], frame_.global_in_local(i), frame_.nodes()[i]));
  return relations;
}

/// Square of the size of what the conditions of the nodes require, N^2.
static double square_of(const std::vector<NodeCondition> &nodes)
{
  double sum = 0;
  for (const NodeCondition &node : nodes)
    sum += node.right_side.squaredNorm() + node.fixed.squaredNorm();
  return sum;
}

/// Size of what the conditions require, N: an inexact Newton step must leave no more than a share of it.
static double size_of(const ContactConditions &conditions)
{
  return std::sqrt(sum_over_ranks(conditions.residual.squaredNorm()) +
                   conditions.face_right_side.squaredNorm() + square_of(conditions.nodes));
}

/// The conditions of the nodes under a motion of the face by 1.
static std::vector<NodeCondition> conditions_of_column(const ContactConditions &conditions,
                                                       const Index column)
{
  std::vector<NodeCondition> nodes = conditions.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const Vector3d moved = conditions.face.col(column).segment<3>(3 * static_cast<Index>(i));
    nodes[i].fixed.setZero();
    nodes[i].right_side = -nodes[i].rows.transpose() * moved;
  }
  return nodes;
}

/// The conditions of a Newton step on the whole body: K u = residual + contact forces, where each contact
/// node gives three equations between its force and its displacement. An open node gives its force, a node
/// that sticks its displacement. One that slips gives one of each: u_z follows u_t, and f_t + coupling f_z +
/// robin u_t is known (NodeRelation). The forces are eliminated by these, so that displacements alone are
/// unknown:
///   T K (u_given + F y) + R y = b,
/// where F makes u of the free displacements y and T makes left sides of forces (HeldStiffness). F and T^T
/// differ wherever slip is not associated, so that the operator is not symmetric. Flexible GMRES (Saad, SIAM
/// J. Sci. Comput. 14 (1993) 461-469) allows for a preconditioner in single precision, whose rounding is
/// another one in every iteration.
ContactChange WholeBodyConditions::solve_nodes(const std::vector<NodeRelation> &relations,
                                               const VectorXd &residual, const double bound) const
{
  constexpr unsigned int most_iterations = 60;
  const HeldStiffness held(stiffness_, frame_.nodes(), relations);
  BodyVector<double> displacement = held.given(), forces = stiffness_.make_vector();
  stiffness_.vmult(forces, displacement);
  const BodyVector<double> right_side = held.right_side(forces, residual);
  BodyVector<double> free = stiffness_.make_vector();
  // The solution is as accurate as asked for, or as far as the iterations come: Newton's method corrects it.
  dealii::IterationNumberControl control(most_iterations, bound, false, false);
  dealii::SolverFGMRES<BodyVector<double>> gmres(
      control, dealii::SolverFGMRES<BodyVector<double>>::AdditionalData(most_iterations));
  if (right_side.l2_norm() > bound)
    gmres.solve(held, free, right_side, cycle_);
  held.add_displacement(displacement, free);
  stiffness_.vmult(forces, displacement);
  return contact_change(frame_, displacement, forces, residual);
}

/// With a face that forces drive, its motion y obeys C^T r - S y = g. r is linear in y, r = r_0 + R y, where
/// each column of R is the answer to a motion of 1. So y solves the small system (C^T R - S) y = g - C^T r_0.
/// Eliminates the face, which takes one more solution for each of its columns.
ContactChange WholeBodyConditions::solve(const ContactConditions &conditions, const double accuracy) const
{
  const std::vector<NodeRelation> relations = relations_of(conditions.nodes);
  cycle_.hold(relations);
  const double bound = accuracy * size_of(conditions);
  ContactChange change = solve_nodes(relations, conditions.residual, bound);
  const Index m = conditions.face.cols();
  if (m == 0)
    return change;
  MatrixXd answers(m, m);
  std::vector<ContactChange> columns;
  for (Index j = 0; j < m; ++j)
  {
    const std::vector<NodeCondition> nodes = conditions_of_column(conditions, j);
    // Where all nodes slide, little resists: no force at all would be within the bound.
    const double of_column = accuracy * std::sqrt(square_of(nodes));
    columns.push_back(solve_nodes(relations_of(nodes), {}, std::min(bound, of_column)));
    answers.col(j) = conditions.face.transpose() * columns.back().force;
  }
  if (conditions.face_stiffness.size() > 0)
    answers -= conditions.face_stiffness;
  change.face =
      answers.fullPivLu().solve(conditions.face_right_side - conditions.face.transpose() * change.force);
  for (Index j = 0; j < m; ++j)
  {
    change.force += change.face[j] * columns[j].force;
    change.displacement += change.face[j] * (columns[j].displacement + conditions.face.col(j));
    change.body = change.body.moved(change.face[j], columns[j].body);
  }
  return change;
}
} // namespace orthocone
