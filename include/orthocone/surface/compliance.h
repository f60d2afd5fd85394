// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/condition_solver.h>

#include <Eigen/Dense>

#include <memory>

namespace orthocone
{
/// Compliance W of an elastic body condensed to its contact nodes: forces r of the obstacle on the body (N)
/// -> displacements W r of the contact nodes (mm). Symmetric and positive definite. A direction in which a
/// node cannot move (a symmetry plane) has a compliance of its own, coupled with nothing, so that it never
/// carries a force.
class Compliance
{
public:
  virtual ~Compliance() = default;

  virtual Eigen::Index n_nodes() const = 0;

  /// displacement = W force; both of size 3 n_nodes().
  virtual void vmult(NodeVector &displacement, const NodeVector &force) const = 0;

  /// The 3 x 3 block of W of one node.
  virtual Eigen::Matrix3d diagonal_block(Eigen::Index node) const = 0;

  /// W itself where the backend has it, else nullptr.
  virtual const Eigen::MatrixXd *dense() const { return nullptr; }

  /// A solver of linearized contact laws where the backend has one, else nullptr. `softness`: softness(). It
  /// must not outlive the compliance.
  virtual std::unique_ptr<ConditionSolver> condition_solver(double softness) const;

  /// Largest eigenvalue of W (mm/N), from below, by power iterations until they settle to about 0.1 %.
  double softness() const;
};

/// Compliance stored as a dense matrix.
class DenseCompliance : public Compliance
{
public:
  /// `matrix`: 3 n x 3 n, symmetric.
  explicit DenseCompliance(Eigen::MatrixXd matrix);

  Eigen::Index n_nodes() const override { return matrix_.rows() / 3; }
  void vmult(NodeVector &displacement, const NodeVector &force) const override;
  Eigen::Matrix3d diagonal_block(Eigen::Index node) const override;
  const Eigen::MatrixXd *dense() const override { return &matrix_; }
  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;

private:
  Eigen::MatrixXd matrix_;
};
} // namespace orthocone
