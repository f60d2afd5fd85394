// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/elasticity/axisymmetric_body.h>
#include <orthocone/elasticity/discretization.h>
#include <orthocone/parameters/options.h>

#include <deal.II/lac/sparse_matrix.h>

#include <Eigen/Dense>

namespace orthocone
{
/// Lame's parameters in MPa.
struct LameParameters
{
  explicit LameParameters(const MaterialOptions &material);

  double lambda;
  double mu;
};

/// Fills `pattern` with the entries of a stiffness on and below the diagonal.
void make_stiffness_pattern(const Discretization &discretization, dealii::SparsityPattern &pattern);
void make_stiffness_pattern(const SectionDiscretization &discretization, dealii::SparsityPattern &pattern);

/// Stiffness of the free degrees of freedom, n_free() x n_free() (N/mm), of isotropic linear elasticity at
/// small strain. Only the entries on and below the diagonal are stored.
class Stiffness
{
public:
  Stiffness(const Discretization &discretization, const MaterialOptions &material);

  /// Of whole rings.
  Stiffness(const SectionDiscretization &discretization, const MaterialOptions &material);

  const dealii::SparseMatrix<double> &matrix() const { return matrix_; }

  /// Forces K u on the free degrees of freedom.
  Eigen::VectorXd vmult(const Eigen::VectorXd &displacement) const;

  /// What rounding leaves in vmult(), N: the machine's precision times the norm of |K| |u|.
  double rounding(const Eigen::VectorXd &displacement) const;

private:
  void assemble(const Discretization &discretization, const LameParameters &lame);

  dealii::SparsityPattern pattern_;
  dealii::SparseMatrix<double> matrix_;
};
} // namespace orthocone
