// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "newton_system.h"

#include "krylov.h"

#include <cmath>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Eigen::VectorXf;

NewtonSystem::NewtonSystem(const ContactProblem &problem, const NodeVector &force,
                           const NodeVector &displacement, const double rho_factor)
    : problem_(&problem)
{
  nodes_.reserve(problem.n_nodes());
  for (Index node = 0; node < problem.n_nodes(); ++node)
  {
    nodes_.push_back(linearize(node, rho_factor * problem.rho(node), force.segment<3>(3 * node),
                               displacement.segment<3>(3 * node)));
    nodes_.back().first = n_unknowns_;
    n_unknowns_ += nodes_.back().n_unknowns();
  }
  error_ = std::sqrt(error_);
}

NewtonSystem::Node NewtonSystem::linearize(const Index node, const double rho, const Vector3d &force,
                                           const Vector3d &displacement)
{
  const OrthotropicFriction &law = problem_->law(node);
  const Projection projection =
      project_with_derivative(law, force - rho * modified_displacement(law, displacement));
  const Vector3d map = force - projection.point;
  error_ += map.squaredNorm();
  Node result;
  result.zone = projection.zone;
  if (projection.zone == ConeZone::polar)
  {
    result.fixed = -map;
    return result;
  }
  const double relative_rho = rho * problem_->largest_compliance();
  const Matrix3d slope = relative_rho * modified_displacement_derivative(law, displacement);
  if (projection.zone == ConeZone::inside)
  {
    result.basis.setIdentity();
    result.rows = slope.transpose().cast<float>();
    result.from_rows = slope.inverse().cast<float>();
    result.right_side = -map;
    return result;
  }
  // I - P = normal normal^T + (1 - stiffness) side side^T: the part along `normal` stands alone.
  const Vector3d across = projection.stiffness * slope.transpose() * projection.side;
  const Matrix3d own = problem_->compliance().diagonal_block(node) / problem_->largest_compliance();
  const double diagonal = 1 - projection.stiffness;
  result.basis.leftCols<2>() << projection.ray.cast<float>(), projection.side.cast<float>();
  result.rows.leftCols<2>() << (slope.transpose() * projection.ray).cast<float>(), across.cast<float>();
  result.fixed = -projection.normal.dot(map) * projection.normal;
  result.right_side.head<2>() << -projection.ray.dot(map), -projection.side.dot(map);
  result.diagonal = static_cast<float>(diagonal);
  if (const double entry = diagonal + across.dot(own * projection.side); entry > 0)
    result.across = static_cast<float>(entry);
  return result;
}

VectorXf NewtonSystem::apply(const InnerCompliance &compliance, const VectorXf &unknowns) const
{
  VectorXf forces = VectorXf::Zero(3 * problem_->n_nodes());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (const Node &node = nodes_[i]; node.zone == ConeZone::inside)
      forces.segment<3>(3 * i) = unknowns.segment<3>(node.first);
    else if (node.zone == ConeZone::outside)
      forces.segment<3>(3 * i).noalias() = node.basis.leftCols<2>() * unknowns.segment<2>(node.first);
  const VectorXf moved = compliance.multiply(forces);
  VectorXf result(n_unknowns_);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (const Node &node = nodes_[i]; node.zone == ConeZone::inside)
      result.segment<3>(node.first).noalias() = node.rows.transpose() * moved.segment<3>(3 * i);
    else if (node.zone == ConeZone::outside)
    {
      result.segment<2>(node.first).noalias() = node.rows.leftCols<2>().transpose() * moved.segment<3>(3 * i);
      result[node.first + 1] += node.diagonal * unknowns[node.first + 1];
    }
  return result;
}

/// Close to the inverse: a stuck node takes the force that its displacement costs, as does the normal
/// direction of a slipping node; across the generator friction itself is soft, and the node stands alone.
VectorXf NewtonSystem::precondition(const InnerCompliance &compliance, const VectorXf &rest) const
{
  VectorXf moved = VectorXf::Zero(3 * problem_->n_nodes());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (const Node &node = nodes_[i]; node.zone == ConeZone::inside)
      moved.segment<3>(3 * i).noalias() = node.from_rows * rest.segment<3>(node.first);
    else if (node.zone == ConeZone::outside)
      moved[3 * i] = rest[node.first] / node.rows(0, 0);
  const VectorXf forces = compliance.multiply_stiffness(moved);
  VectorXf result(n_unknowns_);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (const Node &node = nodes_[i]; node.zone == ConeZone::inside)
      result.segment<3>(node.first) = forces.segment<3>(3 * i);
    else if (node.zone == ConeZone::outside)
    {
      result[node.first] = forces[3 * i] / node.basis(0, 0);
      result[node.first + 1] = rest[node.first + 1] / node.across;
    }
  return result;
}

VectorXd NewtonSystem::right_side(const InnerCompliance &compliance) const
{
  NodeVector fixed(3 * problem_->n_nodes());
  for (Index i = 0; i < problem_->n_nodes(); ++i)
    fixed.segment<3>(3 * i) = nodes_[i].fixed;
  const double size = fixed.norm();
  VectorXd moved = VectorXd::Zero(fixed.size());
  if (size > 0)
    moved = size * compliance.multiply((fixed / size).cast<float>()).cast<double>();
  VectorXd result(n_unknowns_);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (Index row = 0; row < nodes_[i].n_unknowns(); ++row)
      result[nodes_[i].first + row] =
          nodes_[i].right_side[row] - nodes_[i].rows.col(row).cast<double>().dot(moved.segment<3>(3 * i));
  return result;
}

NodeVector NewtonSystem::solve(const InnerCompliance &compliance, const float tolerance) const
{
  constexpr Index most_iterations = 60;
  const VectorXd right = right_side(compliance);
  const double size = right.norm();
  VectorXf unknowns = VectorXf::Zero(n_unknowns_);
  if (size > 0)
    unknowns = solve_gmres({n_unknowns_, [&](const VectorXf &x) { return apply(compliance, x); },
                            [&](const VectorXf &x) { return precondition(compliance, x); }},
                           (right / size).cast<float>(), tolerance, most_iterations);
  NodeVector change(3 * problem_->n_nodes());
  for (Index i = 0; i < problem_->n_nodes(); ++i)
  {
    const Node &node = nodes_[i];
    const Index n = node.n_unknowns();
    change.segment<3>(3 * i) =
        node.fixed + size * (node.basis.leftCols(n) * unknowns.segment(node.first, n)).cast<double>();
  }
  return change;
}
} // namespace orthocone
