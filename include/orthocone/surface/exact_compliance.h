// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>

namespace orthocone
{
/// A dense compliance whose conditions are solved by elimination in double precision, however many they are:
/// for a W so close to singular that GMRES in single precision does not get through.
class ExactCompliance : public DenseCompliance
{
public:
  using DenseCompliance::DenseCompliance;

  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;
};

/// The compliance of a few nodes whose neighbours obey linearized laws: a matrix that is not symmetric where
/// slip is not associated. Its conditions are solved in the same way.
class UnsymmetricCompliance : public Compliance
{
public:
  /// `matrix`: 3 n x 3 n, mm/N.
  explicit UnsymmetricCompliance(Eigen::MatrixXd matrix);

  Eigen::Index n_nodes() const override { return matrix_.rows() / 3; }
  void vmult(NodeVector &displacement, const NodeVector &force) const override;
  Eigen::Matrix3d diagonal_block(Eigen::Index node) const override;
  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;

private:
  Eigen::MatrixXd matrix_;
};
} // namespace orthocone
