// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "matrix_free_stiffness.h"

#include <orthocone/body/materials/lame.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/tools.h>

#include <utility>

namespace orthocone
{
namespace
{
/// Degree and number of points are those of the cells, found when they are visited.
template<typename Number>
using Cell = dealii::FEEvaluation<3, -1, 0, 3, Number>;

template<typename Number>
void multiply_strains(Cell<Number> &cell, const Number lambda, const Number mu)
{
  using Vectorized = dealii::VectorizedArray<Number>;
  for (unsigned int q = 0; q < cell.n_q_points; ++q)
  {
    auto stress = cell.get_symmetric_gradient(q);
    const Vectorized pressure = trace(stress) * lambda;
    stress *= Vectorized(2 * mu);
    for (unsigned int i = 0; i < 3; ++i)
      stress[i][i] += pressure;
    cell.submit_symmetric_gradient(stress, q);
  }
}
} // namespace

template<typename Number>
dealii::AffineConstraints<Number> held_at_zero(const Discretization &space)
{
  dealii::AffineConstraints<Number> constraints;
  for (unsigned int dof = space.n_free(); dof < space.n_dofs(); ++dof)
    constraints.add_line(dof);
  constraints.close();
  return constraints;
}

template<typename Number>
MatrixFreeStiffness<Number>::MatrixFreeStiffness(const Discretization &space, const MaterialOptions &material)
{
  const LameParameters lame(material);
  lambda_ = static_cast<Number>(lame.lambda);
  mu_ = static_cast<Number>(lame.mu);
  typename dealii::MatrixFree<3, Number>::AdditionalData options;
  options.mapping_update_flags = dealii::update_gradients | dealii::update_JxW_values;
  // One thread: sums of one order, the same bytes in every run.
  options.tasks_parallel_scheme = dealii::MatrixFree<3, Number>::AdditionalData::none;
  cells_.reinit(space.mapping(), space.dof_handler(), held_at_zero<double>(space),
                dealii::QGauss<1>(space.n_quadrature_points()), options);
}

template<typename Number>
BodyVector<Number> MatrixFreeStiffness<Number>::make_vector() const
{
  BodyVector<Number> vector;
  cells_.initialize_dof_vector(vector);
  return vector;
}

template<typename Number>
void MatrixFreeStiffness<Number>::vmult(BodyVector<Number> &forces,
                                        const BodyVector<Number> &displacement) const
{
  constexpr bool zero_first = true;
  cells_.template cell_loop<BodyVector<Number>, BodyVector<Number>>(
      [this](const dealii::MatrixFree<3, Number> &cells, BodyVector<Number> &to,
             const BodyVector<Number> &from, const std::pair<unsigned int, unsigned int> &range)
      {
        Cell<Number> cell(cells);
        for (unsigned int i = range.first; i < range.second; ++i)
        {
          cell.reinit(i);
          cell.gather_evaluate(from, dealii::EvaluationFlags::gradients);
          multiply_strains(cell, lambda_, mu_);
          cell.integrate_scatter(dealii::EvaluationFlags::gradients, to);
        }
      },
      forces, displacement, zero_first);
}

template<typename Number>
BodyVector<Number> MatrixFreeStiffness<Number>::diagonal() const
{
  BodyVector<Number> diagonal = make_vector();
  dealii::MatrixFreeTools::compute_diagonal<3, -1, 0, 3, Number, dealii::VectorizedArray<Number>>(
      cells_, diagonal,
      [this](Cell<Number> &cell)
      {
        cell.evaluate(dealii::EvaluationFlags::gradients);
        multiply_strains(cell, lambda_, mu_);
        cell.integrate(dealii::EvaluationFlags::gradients);
      });
  for (const unsigned int dof : cells_.get_constrained_dofs())
    diagonal.local_element(dof) = 0;
  return diagonal;
}

template dealii::AffineConstraints<float> held_at_zero(const Discretization &);
template dealii::AffineConstraints<double> held_at_zero(const Discretization &);
template class MatrixFreeStiffness<float>;
template class MatrixFreeStiffness<double>;
} // namespace orthocone
