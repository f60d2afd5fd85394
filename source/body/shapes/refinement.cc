// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/refinement.h>

#include "common_id.h"

#include <orthocone/base/errors.h>
#include <orthocone/body/shapes/boundary.h>

#include <deal.II/grid/tria_accessor.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace orthocone
{
namespace
{
template<int dim>
constexpr double n_children = 1 << dim;

/// Single cells are counted by meshing them, which must not itself exceed the memory: a million hexahedra
/// take 1 GB.
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
      throw InputError(options.section + "/Refined cells: round " + std::to_string(round + 1) + " has cell " +
                       std::to_string(last) + ": allowed is a number up to " +
                       std::to_string(is_marked.size() - 1) + ", the last cell of the mesh then");
    std::fill(is_marked.begin() + first, is_marked.begin() + last + 1, true);
  }
  return is_marked;
}

template<int dim>
void require_meshable(const dealii::Triangulation<dim> &unrefined, const MeshOptions &options)
{
  if (!options.refined_cells.empty())
    require_meshable(unrefined.n_active_cells() * std::pow(n_children<dim>, options.refinements));
}

using Lines = std::set<unsigned int>;

/// The lines of the contact faces of a cell, by their numbers.
Lines contact_lines(const dealii::Triangulation<3>::active_cell_iterator &cell)
{
  Lines lines;
  for (const auto &face : cell->face_iterators())
    if (face->at_boundary() && is_contact(face->boundary_id()))
      for (const unsigned int i : face->line_indices())
        lines.insert(face->line_index(i));
  return lines;
}

/// Whether the cell has one of these lines of the contact surface, but no face there. On such a line nodes of
/// the contact surface would hang on degrees of freedom that belong to no contact node.
bool is_beside(const dealii::Triangulation<3>::active_cell_iterator &cell, const Lines &lines)
{
  const Lines own = contact_lines(cell);
  const auto indices = cell->line_indices();
  return std::any_of(indices.begin(), indices.end(),
                     [&](const unsigned int i)
                     { return lines.count(cell->line_index(i)) > 0 && own.count(cell->line_index(i)) == 0; });
}

/// Flags cells beside contact faces that are halved, too. Returns whether there are any.
bool halve_beside_contact(dealii::Triangulation<3> &triangulation)
{
  Lines halved;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->refine_flag_set())
      halved.merge(contact_lines(cell));
  bool is_any = false;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (!cell->refine_flag_set() && is_beside(cell, halved))
    {
      cell->set_refine_flag();
      is_any = true;
    }
  return is_any;
}

/// A section has no lines besides its faces.
bool halve_beside_contact(dealii::Triangulation<2> &)
{
  return false;
}

/// Sets the refinement flags of a round. Elements of degree 1 have no degrees of freedom on lines.
template<int dim>
void mark(dealii::Triangulation<dim> &triangulation, const MeshOptions &options, const std::size_t round)
{
  const auto is_marked = marks(triangulation, options, round);
  const auto n_marked = std::count(is_marked.begin(), is_marked.end(), true);
  require_meshable(triangulation.n_active_cells() + (n_children<dim> - 1) * static_cast<double>(n_marked));
  for (const auto &cell : triangulation.active_cell_iterators())
    if (is_marked[cell->active_cell_index()])
      cell->set_refine_flag();
  if (options.degree > 1)
    do
      triangulation.prepare_coarsening_and_refinement(); // flags neighbours, which may have such lines, too
    while (halve_beside_contact(triangulation));
}
} // namespace

template<int dim>
void refine(dealii::Triangulation<dim> &triangulation, const MeshOptions &options)
{
  require_meshable(triangulation, options);
  triangulation.refine_global(options.refinements);
  for (std::size_t round = 0; round < options.refined_cells.size(); ++round)
  {
    mark(triangulation, options, round);
    triangulation.execute_coarsening_and_refinement();
  }
  for (unsigned int i = 0; i < options.coarsenings; ++i)
    triangulation.coarsen_global();
}

void refine_shared(dealii::Triangulation<3> &shared, dealii::Triangulation<3> &whole,
                   const MeshOptions &options)
{
  require_meshable(whole, options);
  shared.refine_global(options.refinements);
  if (!options.refined_cells.empty())
    whole.refine_global(options.refinements);
  for (std::size_t round = 0; round < options.refined_cells.size(); ++round)
  {
    mark(whole, options, round);
    std::set<dealii::CellId> marked;
    for (const auto &cell : whole.active_cell_iterators())
      if (cell->refine_flag_set())
        marked.insert(common_id(cell));
    for (const auto &cell : shared.active_cell_iterators())
      if (cell->is_locally_owned() && marked.count(common_id(cell)) > 0)
        cell->set_refine_flag();
    whole.execute_coarsening_and_refinement();
    shared.execute_coarsening_and_refinement();
  }
  for (unsigned int i = 0; i < options.coarsenings; ++i)
    shared.coarsen_global();
}

std::vector<unsigned int> numbers_in_whole(const dealii::Triangulation<3> &shared,
                                           const dealii::Triangulation<3> &whole)
{
  std::map<dealii::CellId, unsigned int> numbers;
  for (const auto &cell : whole.active_cell_iterators())
    numbers[common_id(cell)] = cell->active_cell_index();
  std::vector<unsigned int> found(shared.n_active_cells(), dealii::numbers::invalid_unsigned_int);
  for (const auto &cell : shared.active_cell_iterators())
    if (cell->is_locally_owned())
      found[cell->active_cell_index()] = numbers.at(common_id(cell));
  return found;
}

template void refine(dealii::Triangulation<2> &, const MeshOptions &);
template void refine(dealii::Triangulation<3> &, const MeshOptions &);
} // namespace orthocone
