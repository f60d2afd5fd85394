// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "coarse_solver.h"

#include <memory>
#include <vector>

namespace orthocone
{
/// Solver for the coarsest mesh of several processes. Forces are summed over all processes, and each one
/// solves the whole mesh on its own, so that none waits for the answer of another.
class ReplicatedCoarse : public CoarseSolver
{
public:
  /// `shared` belongs to this process and others; its mesh has no halved cells.
  ReplicatedCoarse(const Discretization &shared, const MeshOptions &mesh, const GeometryOptions &geometry,
                   const MaterialOptions &material, CoarseMethod method);

  void hold(const std::vector<NodeRelation> &relations) override { solver_->hold(relations); }
  Eigen::VectorXd solve(Eigen::VectorXd forces) const override;

private:
  void number(const Discretization &shared);

  dealii::Triangulation<3> triangulation_;
  std::unique_ptr<const Discretization> whole_;
  std::unique_ptr<CoarseSolver> solver_;
  std::vector<unsigned int> whole_dof_; ///< for the free degrees of freedom that this process owns
};
} // namespace orthocone
