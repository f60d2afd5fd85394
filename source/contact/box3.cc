// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solvers.h"

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;

Box3::Box3(const ContactProblem &problem, const ContactSolverOptions &options)
    : problem_(problem),
      options_(options)
{
}

SolverReport Box3::solve(NodeVector &force)
{
  constexpr unsigned int iterations_between_checks = 5;
  const auto iterate = [this](NodeVector &r)
  {
    const NodeVector d = problem_.displacement(r);
    for (Index node = 0; node < problem_.n_nodes(); ++node)
    {
      const OrthotropicFriction &law = problem_.given_law(node);
      const Vector3d g = modified_displacement(law, d.segment<3>(3 * node));
      const double rho = rho_of_box3(problem_, node, options_.rho_factor);
      r.segment<3>(3 * node) = project(law, r.segment<3>(3 * node) - rho * g);
    }
  };
  return iterate_until_converged(problem_, options_, iterations_between_checks, force, iterate);
}
} // namespace orthocone
