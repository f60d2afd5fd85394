// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

#include <cstddef>
#include <vector>

namespace orthocone
{
/// The nodes that hold 99 % of the squared natural map, worst first, or `most` nodes if these are more.
std::vector<Eigen::Index> worst_nodes(const ContactStep &step, const Eigen::VectorXd &unknowns,
                                      const NodeVector &displacement, std::size_t most);

/// Three values of each of these nodes.
Eigen::VectorXd values_at(const std::vector<Eigen::Index> &nodes, const Eigen::VectorXd &values);

/// Compliance of a few nodes whose neighbours obey linearized laws: a dense matrix that is not symmetric
/// where slip is not associated.
class ComplianceOfFewNodes : public Compliance
{
public:
  /// `matrix`: 3 n x 3 n, mm/N.
  explicit ComplianceOfFewNodes(Eigen::MatrixXd matrix);

  Eigen::Index n_nodes() const override { return matrix_.rows() / 3; }
  void vmult(NodeVector &displacement, const NodeVector &force) const override;
  Eigen::Matrix3d diagonal_block(Eigen::Index node) const override;

  /// Solves by a dense LU decomposition, whatever accuracy is asked for. There is no face.
  std::unique_ptr<ConditionSolver> condition_solver(double softness) const override;

private:
  Eigen::MatrixXd matrix_;
};
} // namespace orthocone
