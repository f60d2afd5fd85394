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
/// The cost of a factorization, found without computing it.
struct FactorizationCost
{
  double entries; ///< of the factor
  double flops;
};

/// Cost of StiffnessFactor's factorization of a matrix with these entries on and below the diagonal, whose
/// last unknowns, from `n_interior` on, are eliminated last. Throws TooLargeError if CHOLMOD cannot count
/// them.
FactorizationCost factorization_cost(const dealii::SparsityPattern &pattern, unsigned int n_interior);

/// Sparse Cholesky factorization (CHOLMOD, supernodal) of a symmetric positive definite matrix whose last
/// unknowns are eliminated last. The trailing block of the factor is then the factor of the Schur complement
/// of these unknowns: condensation costs no solves.
class StiffnessFactor
{
public:
  /// `matrix` holds the entries on and below the diagonal; unknowns from `n_interior` on come last. Throws
  /// std::runtime_error if the matrix is not positive definite, std::bad_alloc if memory runs out,
  /// TooLargeError if CHOLMOD cannot count the entries.
  StiffnessFactor(const dealii::SparseMatrix<double> &matrix, unsigned int n_interior);
  ~StiffnessFactor();
  StiffnessFactor(const StiffnessFactor &) = delete;
  StiffnessFactor &operator=(const StiffnessFactor &) = delete;

  /// Solution x of matrix x = right_side, both of the matrix's size. Throws std::bad_alloc if memory runs
  /// out.
  Eigen::VectorXd solve(const Eigen::VectorXd &right_side) const;

  /// Inverse of the Schur complement of the last m unknowns, in their order: m x m, dense and symmetric (mm/N
  /// for a stiffness). Throws std::runtime_error if it is singular, std::bad_alloc if memory runs out.
  Eigen::MatrixXd trailing_inverse() const;

  /// The same in a larger matrix, `size` x `size`: its row and column places[k] belong to the kth of the last
  /// unknowns, and the others are 0. `places` are m different numbers below `size`. There is no other dense
  /// matrix in memory.
  Eigen::MatrixXd trailing_inverse(const std::vector<Eigen::Index> &places, Eigen::Index size) const;

private:
  struct Cholmod;
  Eigen::Index n_trailing() const;
  void copy_trailing_factor(Eigen::MatrixXd &matrix) const;
  std::vector<Eigen::Index> targets(const std::vector<Eigen::Index> &places, Eigen::Index size) const;

  std::unique_ptr<Cholmod> cholmod_;
  unsigned int n_interior_;
};
} // namespace orthocone
