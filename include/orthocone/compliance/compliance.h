// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

namespace orthocone
{
/// Vectors over the contact nodes hold three numbers a node, in local axes: normal, x, y.
using NodeVector = Eigen::VectorXd;

/// Compliance W of an elastic body condensed to its contact nodes: forces r of the plane on the body (N) ->
/// displacements W r of the contact nodes (mm). Symmetric and positive definite. A direction in which a node
/// cannot move (a symmetry plane) has a compliance of its own, coupled with nothing, so that it never carries
/// a force.
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

private:
  Eigen::MatrixXd matrix_;
};
} // namespace orthocone
