// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solvers.h"

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;

GaussSeidel::GaussSeidel(const ContactProblem &problem, const ContactSolverOptions &options)
    : problem_(problem),
      options_(options)
{
  dense_compliance(problem, "gauss-seidel");
  for (Index node = 0; node < problem.n_nodes(); ++node)
  {
    const Eigen::Matrix3d block = problem.compliance().diagonal_block(node);
    nodes_.push_back({problem.law(node), block, block.inverse()});
  }
}

void GaussSeidel::sweep(NodeVector &force, const double relaxation) const
{
  const Eigen::MatrixXd &w = *problem_.compliance().dense();
  const NodeVector &q = problem_.free_displacement();
  for (Index node = 0; node < problem_.n_nodes(); ++node)
  {
    const OneNodeProblem &one = nodes_[node];
    const Vector3d old = force.segment<3>(3 * node);
    // W is symmetric, and its columns are contiguous.
    const Vector3d others =
        q.segment<3>(3 * node) + w.middleCols<3>(3 * node).transpose() * force - one.compliance * old;
    const Vector3d exact = solve_one_node(one, others, old);
    if (relaxation == 1)
      force.segment<3>(3 * node) = exact;
    else
      force.segment<3>(3 * node) = project(one.law, old + relaxation * (exact - old));
  }
}

SolverReport GaussSeidel::solve(NodeVector &force)
{
  constexpr unsigned int iterations_between_checks = 5;
  return iterate_until_converged(problem_, options_, iterations_between_checks, force,
                                 [this](NodeVector &r) { sweep(r, options_.relaxation); });
}
} // namespace orthocone
