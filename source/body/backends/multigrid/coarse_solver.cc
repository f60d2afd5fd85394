// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "coarse_solver.h"

#include "algebraic_coarse.h"
#include "factorized_coarse.h"

namespace orthocone
{
namespace
{
/// docs/performance.md, "Large coarsest meshes".
bool is_large(const Discretization &space)
{
  constexpr unsigned int most_free = 150000;
  constexpr std::size_t most_contact_nodes = 1500;
  return space.n_free() > most_free || space.contact_surface().nodes.size() > most_contact_nodes;
}
} // namespace

std::unique_ptr<CoarseSolver> make_coarse_solver(const Discretization &space, const MaterialOptions &material,
                                                 const CoarseMethod method)
{
  if (method == CoarseMethod::algebraic || (method == CoarseMethod::by_size && is_large(space)))
    return std::make_unique<AlgebraicCoarse>(space, material);
  return std::make_unique<FactorizedCoarse>(space, material);
}
} // namespace orthocone
