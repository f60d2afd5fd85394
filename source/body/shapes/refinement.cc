// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/refinement.h>

#include <orthocone/base/errors.h>

#include <deal.II/grid/tria_accessor.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace orthocone
{
namespace
{
/// Single cells are counted by meshing them, which must not itself be too much: a million hexahedra take a
/// GB.
void require_meshable(const double n_cells)
{
  constexpr unsigned int most = 4000000;
  if (n_cells > most)
    throw TooLargeError("Mesh/Refined cells: more than " + std::to_string(most) +
                        " cells follow: a coarser mesh or fewer rounds need less");
}

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
  constexpr double children = 1 << dim;
  if (!options.refined_cells.empty())
    require_meshable(triangulation.n_active_cells() * std::pow(children, options.refinements));
  triangulation.refine_global(options.refinements);
  for (std::size_t round = 0; round < options.refined_cells.size(); ++round)
  {
    const auto is_marked = marks(triangulation, options, round);
    const auto n_marked = std::count(is_marked.begin(), is_marked.end(), true);
    require_meshable(triangulation.n_active_cells() + (children - 1) * static_cast<double>(n_marked));
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
