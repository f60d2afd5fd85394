// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "coarse_solver.h"

#include <orthocone/body/backends/stiffness_factor.h>
#include <orthocone/body/fe/stiffness.h>

#include <vector>

namespace orthocone
{
/// Solver for a coarsest mesh that is small. It is exact: the stiffness is factorized once, and held
/// directions are a small dense system in its compliance.
class FactorizedCoarse : public CoarseSolver
{
public:
  /// `space` must outlive the solver. Throws as StiffnessFactor does.
  FactorizedCoarse(const Discretization &space, const MaterialOptions &material);

  void hold(const std::vector<NodeRelation> &relations) override;
  Eigen::VectorXd solve(Eigen::VectorXd forces) const override;

private:
  const Discretization &space_;
  StiffnessFactor factor_;
  Eigen::MatrixXd compliance_; ///< of the contact unknowns, mm/N
  // Contact reacts with forces f at these degrees of freedom, such that of_force f + of_displacement u = 0.
  std::vector<unsigned int> answering_;
  Eigen::MatrixXd of_displacement_;
  Eigen::PartialPivLU<Eigen::MatrixXd> system_;
};
} // namespace orthocone
