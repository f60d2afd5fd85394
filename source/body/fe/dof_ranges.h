// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/hanging_dofs.h>
#include <orthocone/body/shapes/boundary.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace orthocone
{
/// Ends of the ranges of degrees of freedom: interior, contact, held; what is behind them hangs.
struct DofRanges
{
  unsigned int n_interior;
  unsigned int n_free;
  unsigned int n_not_hanging;
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

/// Where cells border on smaller ones, the displacement of their common nodes by that of others.
template<int dim>
dealii::AffineConstraints<double> hanging_constraints(const dealii::DoFHandler<dim> &dof_handler)
{
  dealii::AffineConstraints<double> constraints;
  dealii::DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  constraints.close();
  return constraints;
}

/// Numbers the degrees of freedom in these ranges; within a range their order stays. What is held does not
/// hang.
template<int dim>
DofRanges number_by_range(dealii::DoFHandler<dim> &dof_handler, const std::vector<bool> &is_held)
{
  const dealii::IndexSet on_contact = dealii::DoFTools::extract_boundary_dofs(
      dof_handler, dealii::ComponentMask(dim, true), {Boundary::contact_surface});
  const auto constraints = hanging_constraints(dof_handler);
  enum Range
  {
    interior,
    contact,
    held,
    hanging
  };
  const auto range = [&](const unsigned int dof)
  {
    return is_held[dof]                      ? held
           : constraints.is_constrained(dof) ? hanging
           : on_contact.is_element(dof)      ? contact
                                             : interior;
  };
  std::vector<dealii::types::global_dof_index> new_number(dof_handler.n_dofs());
  DofRanges ranges{0, 0, 0};
  unsigned int next = 0;
  for (const Range wanted : {interior, contact, held, hanging})
  {
    for (unsigned int dof = 0; dof < new_number.size(); ++dof)
      if (range(dof) == wanted)
        new_number[dof] = next++;
    if (wanted == interior)
      ranges.n_interior = next;
    if (wanted == contact)
      ranges.n_free = next;
    if (wanted == held)
      ranges.n_not_hanging = next;
  }
  dof_handler.renumber_dofs(new_number);
  return ranges;
}

/// The sums of the hanging ones, in the order of their numbers. Held degrees of freedom have no part in them.
template<int dim>
std::vector<HangingDofs::Terms> hanging_sums(const dealii::DoFHandler<dim> &dof_handler,
                                             const DofRanges &ranges)
{
  const auto constraints = hanging_constraints(dof_handler);
  std::vector<HangingDofs::Terms> sums;
  for (unsigned int dof = ranges.n_not_hanging; dof < dof_handler.n_dofs(); ++dof)
  {
    sums.emplace_back();
    for (const auto &[other, weight] : *constraints.get_constraint_entries(dof))
      if (other < ranges.n_free)
        sums.back().push_back({static_cast<unsigned int>(other), weight});
  }
  return sums;
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
