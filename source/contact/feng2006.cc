// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solvers.h"

#include <cmath>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;

Feng2006::Feng2006(const ContactProblem &problem, const ContactSolverOptions &options)
    : problem_(problem),
      options_(options)
{
  dense_compliance(problem, "feng2006");
  for (Index node = 0; node < problem.n_nodes(); ++node)
    rho_.push_back(rho_of_box3(problem, node, options.rho_factor));
}

void Feng2006::sweep(NodeVector &force) const
{
  const Eigen::MatrixXd &w = *problem_.compliance().dense();
  const NodeVector &q = problem_.free_displacement();
  for (Index node = 0; node < problem_.n_nodes(); ++node)
  {
    const OrthotropicFriction &law = problem_.given_law(node);
    const Vector3d d = q.segment<3>(3 * node) + w.middleCols<3>(3 * node).transpose() * force;
    const Vector3d r = force.segment<3>(3 * node);
    force.segment<3>(3 * node) = project(law, r - rho_[node] * modified_displacement(law, d));
  }
}

SolverReport Feng2006::solve(NodeVector &force)
{
  constexpr unsigned int iterations_between_checks = 5;
  return iterate_until_converged(problem_, options_, iterations_between_checks, force,
                                 [this](NodeVector &r) { sweep(r); });
}
} // namespace orthocone
