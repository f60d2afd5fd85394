// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/surface/turned_compliance.h>

#include <utility>

namespace orthocone
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

TurnedCompliance::TurnedCompliance(std::unique_ptr<const Compliance> plain, LocalAxes axes)
    : plain_(std::move(plain)),
      axes_(std::move(axes))
{
}

Matrix3d TurnedCompliance::turn(const Index node) const
{
  const Matrix3d &local = axes_.global_in_local(static_cast<std::size_t>(node));
  Matrix3d turn;
  turn << local.row(2), local.row(0), local.row(1);
  return turn;
}

NodeVector TurnedCompliance::turned(const NodeVector &local) const
{
  NodeVector plain(local.size());
  for (Index node = 0; node < n_nodes(); ++node)
    plain.segment<3>(3 * node) = turn(node) * local.segment<3>(3 * node);
  return plain;
}

NodeVector TurnedCompliance::turned_back(const NodeVector &plain) const
{
  NodeVector local(plain.size());
  for (Index node = 0; node < n_nodes(); ++node)
    local.segment<3>(3 * node) = turn(node).transpose() * plain.segment<3>(3 * node);
  return local;
}

void TurnedCompliance::vmult(NodeVector &displacement, const NodeVector &force) const
{
  NodeVector plain;
  plain_->vmult(plain, turned(force));
  displacement = turned_back(plain);
}

Matrix3d TurnedCompliance::diagonal_block(const Index node) const
{
  return turn(node).transpose() * plain_->diagonal_block(node) * turn(node);
}

Vector3d TurnedCompliance::displacement_at(const Index node, const NodeVector &force) const
{
  return turn(node).transpose() * plain_->displacement_at(node, turned(force));
}

/// The conditions of a node are equations between its own force and displacement: where these are turned, so
/// are the columns that meet them.
class TurnedCompliance::Solver : public ConditionSolver
{
public:
  Solver(const TurnedCompliance &compliance, std::unique_ptr<ConditionSolver> plain)
      : compliance_(compliance),
        plain_(std::move(plain))
  {
  }

  ContactChange solve(const ContactConditions &conditions, const double accuracy) const override
  {
    ContactChange change = plain_->solve(turned(conditions), accuracy);
    change.force = compliance_.turned_back(change.force);
    if (change.displacement.size() > 0)
      change.displacement = compliance_.turned_back(change.displacement);
    return change;
  }

private:
  ContactConditions turned(ContactConditions conditions) const
  {
    for (Index node = 0; node < compliance_.n_nodes(); ++node)
    {
      const Matrix3d turn = compliance_.turn(node);
      NodeCondition &condition = conditions.nodes[static_cast<std::size_t>(node)];
      if (condition.n_unknowns < 3) // three unknowns are the force, in whatever axes
        condition.basis = turn * condition.basis;
      condition.rows = turn * condition.rows;
      condition.fixed = turn * condition.fixed;
    }
    for (Index column = 0; column < conditions.face.cols(); ++column)
      conditions.face.col(column) = compliance_.turned(conditions.face.col(column));
    return conditions;
  }

  const TurnedCompliance &compliance_;
  std::unique_ptr<ConditionSolver> plain_;
};

std::unique_ptr<ConditionSolver> TurnedCompliance::condition_solver(const double softness) const
{
  auto plain = plain_->condition_solver(softness);
  return plain ? std::make_unique<Solver>(*this, std::move(plain)) : nullptr;
}
} // namespace orthocone
