// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>

#include <deal.II/dofs/dof_handler.h>

#include <vector>

namespace orthocone
{
/// Local degrees of freedom of a cell, node by node: component c of scalar node a is entry n_components
/// a + c.
template<int dim>
std::vector<dealii::types::global_dof_index> dofs_by_node(const DisplacementSpace<dim> &space,
                                                          const typename DisplacementSpace<dim>::Cell &cell)
{
  const auto &fe = cell->get_fe();
  std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
  std::vector<dealii::types::global_dof_index> sorted(dofs.size());
  cell->get_dof_indices(dofs);
  for (unsigned int i = 0; i < dofs.size(); ++i)
  {
    const auto [component, node] = fe.system_to_component_index(i);
    sorted[space.n_components() * node + component] = space.local_dof(dofs[i]);
  }
  return sorted;
}
} // namespace orthocone
