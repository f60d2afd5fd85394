// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "../shapes/common_id.h"

#include <orthocone/body/hanging_dofs.h>
#include <orthocone/body/shapes/boundary.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/distributed/tria_base.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace orthocone
{
/// Whether several processes share the cells of a mesh, or each has its own mesh.
template<int dim>
bool is_distributed(const dealii::Triangulation<dim> &triangulation)
{
  return dynamic_cast<const dealii::parallel::TriangulationBase<dim> *>(&triangulation) != nullptr;
}

/// The degrees of freedom that this process owns, and as ghosts the others of its cells and those that move
/// hanging ones there.
template<int dim>
std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
make_partitioner(const dealii::DoFHandler<dim> &dof_handler, const dealii::AffineConstraints<double> &hanging)
{
  if (!is_distributed(dof_handler.get_triangulation()))
    return std::make_shared<dealii::Utilities::MPI::Partitioner>(
        static_cast<unsigned int>(dof_handler.n_dofs()));
  dealii::IndexSet ghosts = dealii::DoFTools::extract_locally_active_dofs(dof_handler);
  std::vector<dealii::types::global_dof_index> movers;
  for (const auto &line : hanging.get_lines())
    if (ghosts.is_element(line.index))
      for (const auto &entry : line.entries)
        movers.push_back(entry.first);
  std::sort(movers.begin(), movers.end());
  ghosts.add_indices(movers.begin(), std::unique(movers.begin(), movers.end()));
  ghosts.compress();
  return std::make_shared<dealii::Utilities::MPI::Partitioner>(dof_handler.locally_owned_dofs(), ghosts,
                                                               dof_handler.get_communicator());
}

/// The hanging ones of the partitioner's degrees of freedom, by local numbers. Held ones are left out of the
/// sums.
inline HangingDofs local_hanging_dofs(const dealii::Utilities::MPI::Partitioner &partitioner,
                                      const dealii::AffineConstraints<double> &hanging,
                                      const dealii::IndexSet &held)
{
  const auto is_local = [&](const auto dof)
  { return partitioner.in_local_range(dof) || partitioner.is_ghost_entry(dof); };
  std::vector<unsigned int> numbers;
  std::vector<HangingDofs::Terms> sums;
  for (const auto &line : hanging.get_lines())
    if (is_local(line.index) && !held.is_element(line.index))
    {
      numbers.push_back(partitioner.global_to_local(line.index));
      sums.emplace_back();
      for (const auto &[other, weight] : line.entries)
        if (!held.is_element(other))
          sums.back().push_back({partitioner.global_to_local(other), weight});
    }
  if (numbers.empty())
    return {};
  return {std::move(numbers), std::move(sums),
          partitioner.locally_owned_size() + partitioner.n_ghost_indices()};
}

/// Ends of the ranges of the degrees of freedom that this process owns, counted from the first of them:
/// interior and contact. Those behind them are held or hang.
struct DofRanges
{
  unsigned int n_interior;
  unsigned int n_free;
};

/// Constraints of the nodes where cells border on smaller ones, in all cells that this process knows: their
/// displacement as a sum over other nodes.
template<int dim>
dealii::AffineConstraints<double> hanging_constraints(const dealii::DoFHandler<dim> &dof_handler)
{
  dealii::AffineConstraints<double> constraints(dealii::DoFTools::extract_locally_relevant_dofs(dof_handler));
  dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  constraints.close();
  return constraints;
}

/// The cells that this process owns, in an order that does not depend on the number of processes.
template<int dim>
std::vector<typename dealii::DoFHandler<dim>::active_cell_iterator>
owned_cells(const dealii::DoFHandler<dim> &dof_handler)
{
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;
  std::vector<std::pair<dealii::CellId, Cell>> cells;
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      cells.emplace_back(common_id(cell), cell);
  std::sort(cells.begin(), cells.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
  std::vector<Cell> sorted;
  for (const auto &cell : cells)
    sorted.push_back(cell.second);
  return sorted;
}

/// The degrees of freedom that this process owns, in the order of the cells. Where there are several
/// processes, the original numbers may depend on how the mesh was made.
template<int dim>
std::vector<dealii::types::global_dof_index> in_order_of_cells(const dealii::DoFHandler<dim> &dof_handler)
{
  const dealii::IndexSet &owned = dof_handler.locally_owned_dofs();
  std::vector<dealii::types::global_dof_index> order, of_cell(dof_handler.get_fe().n_dofs_per_cell());
  std::vector<bool> is_there(owned.n_elements(), false);
  for (const auto &cell : owned_cells(dof_handler))
  {
    cell->get_dof_indices(of_cell);
    for (const auto dof : of_cell)
      if (owned.is_element(dof) && !is_there[owned.index_within_set(dof)])
      {
        is_there[owned.index_within_set(dof)] = true;
        order.push_back(dof);
      }
  }
  return order;
}

/// Numbers the degrees of freedom that this process owns in these ranges. With one process their order within
/// a range stays. What is held does not hang.
template<int dim>
DofRanges number_by_range(dealii::DoFHandler<dim> &dof_handler, const dealii::IndexSet &held)
{
  enum Range : unsigned char
  {
    in_interior,
    in_contact,
    is_held,
    hangs
  };
  const dealii::IndexSet &owned = dof_handler.locally_owned_dofs();
  std::vector<Range> range(owned.n_elements(), in_interior);
  const auto put = [&](const dealii::types::global_dof_index dof, const Range which)
  {
    if (owned.is_element(dof))
      range[owned.index_within_set(dof)] = which;
  };
  for (const auto dof :
       dealii::DoFTools::extract_boundary_dofs(dof_handler, dealii::ComponentMask(), contact_boundaries()))
    put(dof, in_contact);
  const auto constraints = hanging_constraints(dof_handler);
  for (const auto &line : constraints.get_lines())
    put(line.index, hangs);
  for (const auto dof : held)
    put(dof, is_held);
  std::vector<dealii::types::global_dof_index> order(owned.begin(), owned.end());
  if (owned.n_elements() < dof_handler.n_dofs())
    order = in_order_of_cells(dof_handler);
  const auto first = owned.is_empty() ? 0 : *owned.begin();
  std::vector<dealii::types::global_dof_index> new_number(order.size());
  unsigned int ends[4], next = 0;
  for (const Range wanted : {in_interior, in_contact, is_held, hangs})
  {
    for (const auto dof : order)
      if (range[dof - first] == wanted)
        new_number[dof - first] = first + next++;
    ends[wanted] = next;
  }
  dof_handler.renumber_dofs(new_number);
  return {ends[in_interior], ends[in_contact]};
}
} // namespace orthocone
