// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "multigrid_compliance.h"

namespace orthocone
{
/// The compliance of a body without a dense W and of the counterface below it together.
class CounterfaceSum : public Compliance
{
public:
  /// Both must outlive the sum.
  CounterfaceSum(const MultigridCompliance &body, const Compliance &counterface);

  Eigen::Index n_nodes() const override { return body_.n_nodes(); }
  void vmult(NodeVector &displacement, const NodeVector &force) const override;
  ContactChange approximate(const NodeVector &force) const override;
  ContactChange held_at(const Eigen::VectorXd &displacement) const override;
  SolutionMemory &memory() const override { return body_.memory(); }
  double norm(const Eigen::VectorXd &residual) const override { return body_.norm(residual); }
  Eigen::Matrix3d diagonal_block(Eigen::Index node) const override;
  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;
  unsigned long n_gmres_iterations() const override { return counterface_.n_gmres_iterations(); }

  /// The sum of both, which is the largest eigenvalue at most.
  double softness() const override { return softness_of_body_ + softness_of_counterface_; }

private:
  const MultigridCompliance &body_;
  const Compliance &counterface_;
  double softness_of_body_, softness_of_counterface_; ///< mm/N
};
} // namespace orthocone
