// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/refinement.h>

#include <orthocone/base/errors.h>

#include <deal.II/grid/tria_accessor.h>

#include <string>

namespace orthocone
{
namespace
{
template<int dim>
std::vector<bool> marks(const dealii::Triangulation<dim> &triangulation, const MeshOptions &options,
                        const std::size_t round)
{
  std::vector<bool> is_marked(triangulation.n_active_cells(), false);
  for (const auto &[first, last] : options.refined_cells[round])
  {
    if (last >= is_marked.size())
      throw InputError("Mesh/Refined cells: round " + std::to_string(round + 1) + " has cell " +
                       std::to_string(last) + ": allowed is a number up to " +
                       std::to_string(is_marked.size() - 1) + ", the last cell of the mesh then");
    std::fill(is_marked.begin() + first, is_marked.begin() + last + 1, true);
  }
  return is_marked;
}
} // namespace

template<int dim>
void refine(dealii::Triangulation<dim> &triangulation, const MeshOptions &options)
{
  triangulation.refine_global(options.refinements);
  for (std::size_t round = 0; round < options.refined_cells.size(); ++round)
  {
    const auto is_marked = marks(triangulation, options, round);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (is_marked[cell->active_cell_index()])
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
  }
  for (unsigned int i = 0; i < options.coarsenings; ++i)
    triangulation.coarsen_global();
}

template void refine(dealii::Triangulation<2> &, const MeshOptions &);
template void refine(dealii::Triangulation<3> &, const MeshOptions &);
} // namespace orthocone
