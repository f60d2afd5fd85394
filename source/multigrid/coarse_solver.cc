// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "coarse_solver.h"

#include "algebraic_coarse.h"
#include "factorized_coarse.h"

#include <orthocone/multigrid/multigrid_body.h>

namespace orthocone
{
std::unique_ptr<CoarseSolver> make_coarse_solver(const Discretization &space, const MaterialOptions &material,
                                                 const CoarseMethod method)
{
  const auto n_contact_nodes = static_cast<double>(space.contact_surface().nodes.size());
  if (method == CoarseMethod::algebraic ||
      (method == CoarseMethod::by_size &&
       MultigridBody::aggregates_coarsest(space.n_dofs(), n_contact_nodes)))
    return std::make_unique<AlgebraicCoarse>(space, material);
  return std::make_unique<FactorizedCoarse>(space, material);
}
} // namespace orthocone
