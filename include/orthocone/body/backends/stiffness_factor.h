// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/errors.h>

#include <deal.II/lac/sparse_matrix.h>

#include <Eigen/Dense>

#include <memory>
#include <vector>

namespace orthocone
{
/// What a factorization costs, found without computing it.
struct FactorizationCost
{
  double entries; ///< of the factor
  double flops;
};

/// Cost of the factorization that StiffnessFactor does of a matrix with these entries on and below the
/// diagonal. Throws TooLargeError.
FactorizationCost factorization_cost(const dealii::SparsityPattern &pattern, unsigned int n_interior);

/// Sparse Cholesky factorization (CHOLMOD, supernodal) of a symmetric positive definite matrix whose last
/// unknowns are eliminated last. The trailing block of the factor is then the factor of the Schur complement
/// of these unknowns: condensation costs no solves.
class StiffnessFactor
{
public:
  /// `matrix` holds the entries on and below the diagonal; unknowns from `n_interior` on come last. Throws
  /// std::runtime_error if the matrix is not positive definite, std::bad_alloc if memory runs out,
  /// TooLargeError.
  StiffnessFactor(const dealii::SparseMatrix<double> &matrix, unsigned int n_interior);
  ~StiffnessFactor();
  StiffnessFactor(const StiffnessFactor &) = delete;
  StiffnessFactor &operator=(const StiffnessFactor &) = delete;

  /// Solution of matrix x = right_side.
  Eigen::VectorXd solve(const Eigen::VectorXd &right_side) const;

  /// Inverse of the Schur complement of the last unknowns, in their order; dense and symmetric.
  Eigen::MatrixXd trailing_inverse() const;

private:
  struct Cholmod;
  Eigen::MatrixXd trailing_factor() const;

  std::unique_ptr<Cholmod> cholmod_;
  unsigned int n_interior_;
};
} // namespace orthocone
