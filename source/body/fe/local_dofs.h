// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/hanging_dofs.h>

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
} // namespace orthocone
