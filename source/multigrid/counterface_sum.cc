// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "counterface_sum.h"

#include "counterface_conditions.h"

namespace orthocone
{
CounterfaceSum::CounterfaceSum(const MultigridCompliance &body, const Compliance &counterface)
    : body_(body),
      counterface_(counterface),
      softness_of_body_(body.softness()),
      softness_of_counterface_(counterface.softness())
{
}

void CounterfaceSum::vmult(NodeVector &displacement, const NodeVector &force) const
{
  NodeVector given_way;
  counterface_.vmult(given_way, force);
  body_.vmult(displacement, force);
  displacement += given_way;
}

ContactChange CounterfaceSum::approximate(const NodeVector &force) const
{
  ContactChange change = body_.approximate(force);
  NodeVector given_way;
  counterface_.vmult(given_way, force);
  change.displacement += given_way;
  return change;
}

ContactChange CounterfaceSum::held_at(const Eigen::VectorXd &displacement) const
{
  ContactChange change = body_.held_at(displacement);
  NodeVector given_way;
  counterface_.vmult(given_way, change.force);
  change.displacement += given_way;
  return change;
}

Eigen::Matrix3d CounterfaceSum::diagonal_block(const Eigen::Index node) const
{
  return body_.diagonal_block(node) + counterface_.diagonal_block(node);
}

std::unique_ptr<ConditionSolver> CounterfaceSum::condition_solver(double) const
{
  return std::make_unique<CounterfaceConditions>(body_, softness_of_body_, counterface_,
                                                 softness_of_counterface_);
}
} // namespace orthocone
