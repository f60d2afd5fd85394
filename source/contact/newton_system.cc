// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "newton_system.h"

#include <limits>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

NewtonSystem::NewtonSystem(const ContactProblem &problem, const NodeVector &force,
                           const NodeVector &displacement)
    : problem_(problem)
{
  nodes_.reserve(problem.n_nodes());
  for (Index node = 0; node < problem.n_nodes(); ++node)
  {
    nodes_.push_back(linearize(node, force.segment<3>(3 * node), displacement.segment<3>(3 * node)));
    nodes_.back().first = n_unknowns_;
    n_unknowns_ += nodes_.back().n_unknowns;
  }
}

NewtonSystem::Node NewtonSystem::linearize(const Index node, const Vector3d &force,
                                           const Vector3d &displacement) const
{
  const OrthotropicFriction &law = problem_.law(node);
  const double rho = problem_.rho(node);
  const Projection projection =
      project_with_derivative(law, force - rho * modified_displacement(law, displacement));
  const Vector3d map = force - projection.point;
  const Matrix3d slope = rho * modified_displacement_derivative(law, displacement);
  Node result;
  switch (projection.zone)
  {
  case ConeZone::polar:
    result.fixed = -map;
    break;
  case ConeZone::inside:
    result.n_unknowns = 3;
    result.basis.setIdentity();
    result.rows = slope.transpose();
    result.right_side = -map;
    break;
  case ConeZone::outside:
    // I - P = normal normal^T + (1 - stiffness) side side^T: the part along `normal` stands alone.
    result.n_unknowns = 2;
    result.basis.leftCols<2>() << projection.ray, projection.side;
    result.fixed = -projection.normal.dot(map) * projection.normal;
    result.rows.leftCols<2>() << slope.transpose() * projection.ray,
        projection.stiffness * slope.transpose() * projection.side;
    result.diagonal[1] = 1 - projection.stiffness;
    result.right_side.head<2>() << -projection.ray.dot(map), -projection.side.dot(map);
    break;
  }
  return result;
}

MatrixXd NewtonSystem::matrix() const
{
  const MatrixXd &w = *problem_.compliance().dense();
  MatrixXd matrix(n_unknowns_, n_unknowns_);
  for (std::size_t j = 0; j < nodes_.size(); ++j)
    for (Index k = 0; k < nodes_[j].n_unknowns; ++k)
    {
      const VectorXd moved = w.middleCols<3>(3 * static_cast<Index>(j)) * nodes_[j].basis.col(k);
      auto column = matrix.col(nodes_[j].first + k);
      for (std::size_t i = 0; i < nodes_.size(); ++i)
      {
        const Vector3d d = moved.segment<3>(3 * static_cast<Index>(i));
        for (Index row = 0; row < nodes_[i].n_unknowns; ++row)
          column[nodes_[i].first + row] = nodes_[i].rows.col(row).dot(d);
      }
      column[nodes_[j].first + k] += nodes_[j].diagonal[k];
    }
  return matrix;
}

VectorXd NewtonSystem::right_side() const
{
  NodeVector fixed(3 * problem_.n_nodes());
  for (Index i = 0; i < problem_.n_nodes(); ++i)
    fixed.segment<3>(3 * i) = nodes_[i].fixed;
  NodeVector moved;
  problem_.compliance().vmult(moved, fixed);
  VectorXd right_side(n_unknowns_);
  for (Index i = 0; i < problem_.n_nodes(); ++i)
    for (Index row = 0; row < nodes_[i].n_unknowns; ++row)
      right_side[nodes_[i].first + row] =
          nodes_[i].right_side[row] - nodes_[i].rows.col(row).dot(moved.segment<3>(3 * i));
  return right_side;
}

NodeVector NewtonSystem::solve() const
{
  const MatrixXd left = matrix();
  const VectorXd right = right_side();
  // LAPACK leaves the pivots of such a matrix undefined.
  if (!left.allFinite() || !right.allFinite())
    return NodeVector::Constant(3 * problem_.n_nodes(), std::numeric_limits<double>::quiet_NaN());
  const VectorXd unknowns = left.partialPivLu().solve(right);
  NodeVector change(3 * problem_.n_nodes());
  for (Index i = 0; i < problem_.n_nodes(); ++i)
  {
    const Node &node = nodes_[i];
    change.segment<3>(3 * i) =
        node.fixed + node.basis.leftCols(node.n_unknowns) * unknowns.segment(node.first, node.n_unknowns);
  }
  return change;
}
} // namespace orthocone
