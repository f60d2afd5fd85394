// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>
#include <orthocone/body/materials/materials.h>

#include <deal.II/lac/sparse_matrix.h>

#include <Eigen/Dense>

namespace orthocone
{
/// Fills `pattern` with the entries of a stiffness on and below the diagonal, n_free() x n_free().
template<int dim>
void make_stiffness_pattern(const DisplacementSpace<dim> &space, dealii::SparsityPattern &pattern);

/// What hanging nodes add to the diagonal of the stiffness, as a sum over cells: a degree of freedom that
/// moves such a node strains the cell through more than its own node. One number (N/mm) for each of the
/// n_dofs() degrees of freedom; empty where no node hangs.
Eigen::VectorXd diagonal_beside_hanging_nodes(const Discretization &space, const MaterialOptions &material);

/// Stiffness K of the free degrees of freedom, n_free() x n_free() (N/mm), for linear elasticity at small
/// strain; in a section for whole rings. Only the entries on and below the diagonal are stored.
/// docs/theory.md, section 2.
class Stiffness
{
public:
  /// Assembles the stiffness; `space` need not outlive it. Throws std::bad_alloc if memory runs out.
  template<int dim>
  Stiffness(const DisplacementSpace<dim> &space, const Materials &materials);

  const dealii::SparseMatrix<double> &matrix() const { return matrix_; }

  /// Forces K u (N) on the free degrees of freedom; u = `displacement` in mm, both of size n_free().
  Eigen::VectorXd vmult(const Eigen::VectorXd &displacement) const;

  /// The error (N) that rounding leaves in vmult(): the machine's precision times the norm of |K| |u|.
  double rounding(const Eigen::VectorXd &displacement) const;

private:
  dealii::SparsityPattern pattern_;
  dealii::SparseMatrix<double> matrix_;
};
} // namespace orthocone
