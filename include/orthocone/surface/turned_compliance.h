// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/compliance.h>
#include <orthocone/surface/local_axes.h>

#include <memory>

namespace orthocone
{
/// A compliance that is known in the axes (z, x, y) of all nodes, seen in the local axes of the nodes: W' =
/// T^T W T with an orthogonal 3 x 3 block of T for each node. Products and conditions are turned, so that
/// nothing but their answers is needed of W. Only one thread at a time may use it.
class TurnedCompliance : public Compliance
{
public:
  /// `axes` has one frame, or one for each node.
  TurnedCompliance(std::unique_ptr<const Compliance> plain, LocalAxes axes);

  Eigen::Index n_nodes() const override { return plain_->n_nodes(); }
  void vmult(NodeVector &displacement, const NodeVector &force) const override;
  Eigen::Matrix3d diagonal_block(Eigen::Index node) const override;
  Eigen::Vector3d displacement_at(Eigen::Index node, const NodeVector &force) const override;
  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;
  unsigned long n_gmres_iterations() const override { return plain_->n_gmres_iterations(); }
  double softness() const override { return plain_->softness(); } ///< turning does not change it

private:
  class Solver;

  /// T of a node: what leads from its local components to (z, x, y).
  Eigen::Matrix3d turn(Eigen::Index node) const;
  NodeVector turned(const NodeVector &local) const;
  NodeVector turned_back(const NodeVector &plain) const;

  std::unique_ptr<const Compliance> plain_;
  LocalAxes axes_;
};
} // namespace orthocone
