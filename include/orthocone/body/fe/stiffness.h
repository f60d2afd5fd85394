// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>
#include <orthocone/body/materials/materials.h>

#include <deal.II/lac/sparse_matrix.h>

#include <Eigen/Dense>

namespace orthocone
{
/// Fills `pattern` with the entries of a stiffness on and below the diagonal.
template<int dim>
void make_stiffness_pattern(const DisplacementSpace<dim> &space, dealii::SparsityPattern &pattern);

/// What hanging nodes change of the diagonal of the stiffness, a sum over cells: what moves such a node
/// strains the cell in more than its own node. Of all degrees of freedom, N/mm; nothing where no node hangs.
Eigen::VectorXd diagonal_beside_hanging_nodes(const Discretization &space, const MaterialOptions &material);

/// Stiffness of the free degrees of freedom, n_free() x n_free() (N/mm), of linear elasticity at small
/// strain; of a section, of whole rings. Only the entries on and below the diagonal are stored.
class Stiffness
{
public:
  template<int dim>
  Stiffness(const DisplacementSpace<dim> &space, const Materials &materials);

  const dealii::SparseMatrix<double> &matrix() const { return matrix_; }

  /// Forces K u on the free degrees of freedom.
  Eigen::VectorXd vmult(const Eigen::VectorXd &displacement) const;

  /// What rounding leaves in vmult(), N: the machine's precision times the norm of |K| |u|.
  double rounding(const Eigen::VectorXd &displacement) const;

private:
  dealii::SparsityPattern pattern_;
  dealii::SparseMatrix<double> matrix_;
};
} // namespace orthocone
