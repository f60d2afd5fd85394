// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/fe/stress_jumps.h>

#include "local_dofs.h"

#include <orthocone/body/fe/cell_dofs.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/error_estimator.h>

namespace orthocone
{
namespace
{
using SharedVector = dealii::LinearAlgebra::distributed::Vector<double>;

/// Displacements of the degrees of freedom of this process's cells and of their neighbours.
template<int dim>
SharedVector make_vector(const dealii::DoFHandler<dim> &dof_handler)
{
  if (!is_distributed(dof_handler.get_triangulation()))
    return SharedVector(static_cast<unsigned int>(dof_handler.n_dofs()));
  return SharedVector(dof_handler.locally_owned_dofs(),
                      dealii::DoFTools::extract_locally_relevant_dofs(dof_handler),
                      dof_handler.get_communicator());
}

/// Values at the nodes of FE_Q, which is the basis that deal.II knows.
template<int dim>
SharedVector nodal_values(const DisplacementSpace<dim> &space, const Eigen::VectorXd &displacement)
{
  SharedVector values = make_vector(space.dof_handler());
  for (unsigned int i = 0; i < values.locally_owned_size(); ++i)
    values.local_element(i) = displacement[i];
  for (const auto &cell : space.dof_handler().active_cell_iterators())
    if (cell->is_locally_owned() && space.has_axis_face(cell))
    {
      const auto dofs = dofs_by_node(space, cell);
      Eigen::VectorXd of_cell(dofs.size());
      for (std::size_t i = 0; i < dofs.size(); ++i)
        of_cell[i] = displacement[dofs[i]];
      of_cell = (space.axis_face_basis() * of_cell).eval();
      for (std::size_t i = 0; i < dofs.size(); ++i)
        values[dofs[i]] = of_cell[i];
    }
  values.update_ghost_values();
  return values;
}
} // namespace

template<int dim>
Eigen::VectorXd squared_jumps(const DisplacementSpace<dim> &space, const Eigen::VectorXd &displacement)
{
  dealii::Vector<float> jumps(space.dof_handler().get_triangulation().n_active_cells());
  dealii::KellyErrorEstimator<dim>::estimate(space.mapping(), space.dof_handler(),
                                             dealii::QGauss<dim - 1>(space.scalar_fe().degree + 1), {},
                                             nodal_values(space, displacement), jumps);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(jumps.size());
  for (const auto &cell : space.dof_handler().active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    const double jump = jumps[cell->active_cell_index()];
    // The length of a ring is proportional to its radius.
    const bool is_ring = dim == 2 && space.section().is_revolved();
    squares[cell->active_cell_index()] = (is_ring ? cell->center()[0] : 1) * jump * jump;
  }
  return squares;
}

template Eigen::VectorXd squared_jumps(const Discretization &, const Eigen::VectorXd &);
template Eigen::VectorXd squared_jumps(const SectionDiscretization &, const Eigen::VectorXd &);
} // namespace orthocone
