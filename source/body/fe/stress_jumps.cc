// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/fe/stress_jumps.h>

#include <orthocone/body/fe/cell_dofs.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/error_estimator.h>

namespace orthocone
{
namespace
{
/// Values of the nodes of FE_Q, which deal.II knows of.
template<int dim>
dealii::Vector<double> nodal_values(const DisplacementSpace<dim> &space, const Eigen::VectorXd &displacement)
{
  dealii::Vector<double> values(displacement.begin(), displacement.end());
  for (const auto &cell : space.dof_handler().active_cell_iterators())
    if (space.has_axis_face(cell))
    {
      const auto dofs = dofs_by_node(space, cell);
      Eigen::VectorXd of_cell(dofs.size());
      for (std::size_t i = 0; i < dofs.size(); ++i)
        of_cell[i] = displacement[dofs[i]];
      of_cell = (space.axis_face_basis() * of_cell).eval();
      for (std::size_t i = 0; i < dofs.size(); ++i)
        values[dofs[i]] = of_cell[i];
    }
  return values;
}
} // namespace

template<int dim>
Eigen::VectorXd squared_jumps(const DisplacementSpace<dim> &space, const Eigen::VectorXd &displacement)
{
  dealii::Vector<float> jumps(space.size().cells);
  dealii::KellyErrorEstimator<dim>::estimate(space.mapping(), space.dof_handler(),
                                             dealii::QGauss<dim - 1>(space.scalar_fe().degree + 1), {},
                                             nodal_values(space, displacement), jumps);
  Eigen::VectorXd squares(jumps.size());
  for (const auto &cell : space.dof_handler().active_cell_iterators())
  {
    const double jump = jumps[cell->active_cell_index()];
    // A ring is as long as its radius says.
    squares[cell->active_cell_index()] = (dim == 2 ? cell->center()[0] : 1) * jump * jump;
  }
  return squares;
}

template Eigen::VectorXd squared_jumps(const Discretization &, const Eigen::VectorXd &);
template Eigen::VectorXd squared_jumps(const SectionDiscretization &, const Eigen::VectorXd &);
} // namespace orthocone
