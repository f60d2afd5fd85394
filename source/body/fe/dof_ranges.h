// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/shapes/boundary.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <vector>

namespace orthocone
{
/// Ends of the ranges of degrees of freedom: interior, contact, held.
struct DofRanges
{
  unsigned int n_interior;
  unsigned int n_free;
};

/// Marks the degrees of freedom of these components on a boundary.
template<int dim>
void hold(const dealii::DoFHandler<dim> &dof_handler, const Boundary boundary,
          const std::vector<bool> &components, std::vector<bool> &is_held)
{
  for (const auto dof :
       dealii::DoFTools::extract_boundary_dofs(dof_handler, dealii::ComponentMask(components), {boundary}))
    is_held[dof] = true;
}

/// Numbers the degrees of freedom in these ranges; within a range their order stays.
template<int dim>
DofRanges number_by_range(dealii::DoFHandler<dim> &dof_handler, const std::vector<bool> &is_held)
{
  const dealii::IndexSet on_contact = dealii::DoFTools::extract_boundary_dofs(
      dof_handler, dealii::ComponentMask(dim, true), {Boundary::contact_surface});
  enum Range
  {
    interior,
    contact,
    held
  };
  const auto range = [&](const unsigned int dof) {
    return is_held[dof] ? held : on_contact.is_element(dof) ? contact : interior;
  };
  std::vector<dealii::types::global_dof_index> new_number(dof_handler.n_dofs());
  DofRanges ranges{0, 0};
  unsigned int next = 0;
  for (const Range wanted : {interior, contact, held})
  {
    for (unsigned int dof = 0; dof < new_number.size(); ++dof)
      if (range(dof) == wanted)
        new_number[dof] = next++;
    if (wanted == interior)
      ranges.n_interior = next;
    if (wanted == contact)
      ranges.n_free = next;
  }
  dof_handler.renumber_dofs(new_number);
  return ranges;
}

/// Direction of every degree of freedom, where component c moves along `axes[c]`.
template<int dim>
std::vector<unsigned char> directions_of(const dealii::DoFHandler<dim> &dof_handler,
                                         const std::array<unsigned char, dim> &axes)
{
  std::vector<unsigned char> directions(dof_handler.n_dofs());
  for (unsigned int c = 0; c < dim; ++c)
  {
    dealii::ComponentMask component(dim, false);
    component.set(c, true);
    for (const auto dof : dealii::DoFTools::extract_dofs(dof_handler, component))
      directions[dof] = axes[c];
  }
  return directions;
}
} // namespace orthocone
