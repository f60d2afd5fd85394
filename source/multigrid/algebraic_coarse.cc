// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "algebraic_coarse.h"

#include <orthocone/base/errors.h>

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <algorithm>

namespace orthocone
{
using Eigen::VectorXd;

AlgebraicCoarse::AlgebraicCoarse(const Discretization &space, const MaterialOptions &material)
    : stiffness_(space, material),
      rigid_motions_(stiffness_.rigid_motions())
{
  if (!aggregate(of_free_, stiffness_.free()))
    throw SolveError("multigrid: the nodes of the coarsest mesh cannot be aggregated; cells that are far "
                     "from cubes make it so, or a Poisson ratio next to 0.5");
}

/// Returns whether ML found a hierarchy. The random numbers are the same every time, because a resumed run
/// must find the same hierarchy.
bool AlgebraicCoarse::aggregate(Hierarchy &hierarchy, const NodeStiffness::Matrix &matrix) const
{
  Teuchos::ParameterList options;
  ML_Epetra::SetDefaults("SA", options);
  options.set("ML output", 0);
  options.set("initialize random seed", true);
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
  hierarchy.clear();
  hierarchy.initialize(matrix, options);
  const auto *const ml =
      dynamic_cast<const ML_Epetra::MultiLevelPreconditioner *>(&hierarchy.trilinos_operator());
  return ml != nullptr && ml->IsPreconditionerComputed();
}

/// If ML finds no hierarchy with the relations of contact, the aggregates of the free body serve: they only
/// precondition.
void AlgebraicCoarse::hold(const std::vector<NodeRelation> &relations)
{
  is_held_ = std::any_of(relations.begin(), relations.end(),
                         [](const NodeRelation &relation) { return relation.hold != Hold::nothing; });
  if (!is_held_)
    return;
  stiffness_.hold(relations, held_);
  is_held_ = aggregate(of_held_, held_);
}

VectorXd AlgebraicCoarse::solve(VectorXd forces) const
{
  dealii::Vector<double> right_side(stiffness_.n_rows()), solution(stiffness_.n_rows());
  for (Eigen::Index dof = 0; dof < forces.size(); ++dof)
    right_side[stiffness_.row(dof)] = forces[dof];
  if (is_held_)
    stiffness_.test(right_side);
  (is_held_ ? of_held_ : of_free_).vmult(solution, right_side);
  if (is_held_)
    stiffness_.clear_held(solution);
  for (Eigen::Index dof = 0; dof < forces.size(); ++dof)
    forces[dof] = solution[stiffness_.row(dof)];
  return forces;
}
} // namespace orthocone
