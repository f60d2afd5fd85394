// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>

#include <Eigen/Sparse>

namespace orthocone
{
/// A compliance most of whose 3 x 3 blocks are zero, as those of many rigid bodies are: nodes of bodies that
/// do not touch each other do not feel each other. The matrix is there as a whole, too, but products read its
/// entries that are not zero, and linearized laws are solved by a sparse factorization.
class SparseCompliance : public DenseCompliance
{
public:
  /// Whether so many blocks of W (3 n x 3 n) are zero that it pays.
  static bool pays_for(const DenseView &w);

  /// W as in DenseCompliance.
  explicit SparseCompliance(Eigen::MatrixXd matrix);
  explicit SparseCompliance(const DenseView &view);

  void vmult(NodeVector &displacement, const NodeVector &force) const override;
  Eigen::Vector3d displacement_at(Eigen::Index node, const NodeVector &force) const override;
  bool is_sparse() const override { return true; }
  std::unique_ptr<Compliance> on_springs(double softness) const override;
  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;

private:
  Eigen::SparseMatrix<double> entries_;
};

/// A matrix W (3 n x 3 n, mm/N), symmetric, as a compliance that uses its zeros where there are many.
std::unique_ptr<DenseCompliance> compliance_of_matrix(Eigen::MatrixXd matrix);

/// The same without a copy: the memory behind `view` must outlive the compliance.
std::unique_ptr<DenseCompliance> compliance_of_matrix(const DenseView &view);
} // namespace orthocone
