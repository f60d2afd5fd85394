// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/matrix_free/matrix_free.h>

namespace orthocone
{
template<typename Number>
using BodyVector = dealii::LinearAlgebra::distributed::Vector<Number>;

/// The held degrees of freedom as constraints: their displacement is zero.
template<typename Number>
dealii::AffineConstraints<Number> held_at_zero(const Discretization &space);

/// Products with the stiffness of a body without its entries, cell by cell. Vectors hold all degrees of
/// freedom, mm or N; those of the held ones are zero.
template<typename Number>
class MatrixFreeStiffness
{
public:
  /// `space` must outlive this.
  MatrixFreeStiffness(const Discretization &space, const MaterialOptions &material);

  BodyVector<Number> make_vector() const;
  void vmult(BodyVector<Number> &forces, const BodyVector<Number> &displacement) const;

  /// N/mm; 0 at held degrees of freedom.
  BodyVector<Number> diagonal() const;

private:
  dealii::MatrixFree<3, Number> cells_;
  Number lambda_; ///< MPa
  Number mu_;     ///< MPa
};
} // namespace orthocone
