// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "algebraic_coarse.h"

#include <Teuchos_ParameterList.hpp>

namespace orthocone
{
using Eigen::VectorXd;

AlgebraicCoarse::AlgebraicCoarse(const Discretization &space, const MaterialOptions &material)
    : stiffness_(space, material),
      rigid_motions_(stiffness_.rigid_motions())
{
  aggregate(of_free_, stiffness_.free());
}

/// docs/performance.md, "Large coarsest meshes", has what other choices cost.
void AlgebraicCoarse::aggregate(Hierarchy &hierarchy, const NodeStiffness::Matrix &matrix) const
{
  Teuchos::ParameterList options;
  options.set("default values", "SA");
  options.set("ML output", 0);
  options.set("smoother: type", "Chebyshev");
  options.set("smoother: sweeps", 3);
  options.set("smoother: Chebyshev alpha", 20.);
  options.set("aggregation: type", "Uncoupled");
  options.set("aggregation: threshold", 0.);
  options.set("coarse: type", "Amesos-KLU");
  options.set("coarse: max size", 2000);
  options.set("PDE equations", 3);
  options.set("null space: type", "pre-computed");
  options.set("null space: dimension", NodeStiffness::n_rigid_motions);
  options.set("null space: vectors", const_cast<double *>(rigid_motions_.data())); // ML only reads them
  hierarchy.initialize(matrix, options);
}

void AlgebraicCoarse::hold(const std::vector<NodeRelation> &relations)
{
  is_held_ = !relations.empty();
  if (!is_held_)
    return;
  stiffness_.hold(relations, held_);
  aggregate(of_held_, held_);
}

VectorXd AlgebraicCoarse::solve(VectorXd forces) const
{
  dealii::Vector<double> right_side(stiffness_.n_rows()), solution(stiffness_.n_rows());
  for (Eigen::Index dof = 0; dof < forces.size(); ++dof)
    right_side[stiffness_.row(dof)] = forces[dof];
  if (is_held_)
    stiffness_.clear_held(right_side);
  (is_held_ ? of_held_ : of_free_).vmult(solution, right_side);
  if (is_held_)
    stiffness_.clear_held(solution);
  for (Eigen::Index dof = 0; dof < forces.size(); ++dof)
    forces[dof] = solution[stiffness_.row(dof)];
  return forces;
}
} // namespace orthocone
