// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "coarse_solver.h"
#include "node_stiffness.h"

#include <deal.II/lac/trilinos_precondition.h>

#include <optional>

namespace orthocone
{
/// Solver for a coarsest mesh that is large: one V-cycle of smoothed aggregation (Trilinos ML) on its
/// assembled stiffness with the relations of contact. Aggregates know all six rigid motions.
class AlgebraicCoarse : public CoarseSolver
{
public:
  /// `space` must outlive the solver. Throws SolveError if ML finds no hierarchy.
  AlgebraicCoarse(const Discretization &space, const MaterialOptions &material);

  void hold(const std::vector<NodeRelation> &relations) override;
  Eigen::VectorXd solve(Eigen::VectorXd forces) const override;

private:
  using Hierarchy = dealii::TrilinosWrappers::PreconditionAMG;

  bool aggregate(Hierarchy &hierarchy, const NodeStiffness::Matrix &matrix) const;

  NodeStiffness stiffness_;
  std::vector<double> rigid_motions_; ///< one after the other, each with all rows
  NodeStiffness::Matrix held_;
  Hierarchy of_free_, of_held_;
  bool is_held_ = false;
};
} // namespace orthocone
