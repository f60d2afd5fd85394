// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

namespace orthocone
{
/// A face that forces drive, as sweeps over the nodes see it: a spring that follows what the face lacks of
/// its balance while the sweep goes on, and whose length is taken over into the face's motion behind the
/// sweep. To the nodes it is a compliance of rank m, as soft as the body; at the solution it carries nothing.
class BalancingFace
{
public:
  /// `unknowns`: those of the step at the beginning of the sweep.
  BalancingFace(const ContactStep &step, const Eigen::VectorXd &unknowns);

  /// What the face and its spring move a node by now, mm.
  Eigen::Vector3d displacement(Eigen::Index node) const;

  /// What the spring adds to a node's own compliance, mm/N.
  Eigen::Matrix3d compliance(Eigen::Index node) const;

  /// A node's force changes.
  void add(Eigen::Index node, const Eigen::Vector3d &change);

  /// Motion of the face behind the sweep, mm.
  Eigen::VectorXd motion() const { return motion_ + softness_ * imbalance_; }

private:
  const Eigen::MatrixXd &columns_;
  double softness_; ///< of the spring, mm/N
  Eigen::VectorXd motion_;
  Eigen::VectorXd imbalance_;
};

/// Finds, from looks at an iteration every few sweeps, that there is no equilibrium: no node sticks, and what
/// the face lacks of its balance does not fall from look to look while the face keeps moving.
class BalanceWatch
{
public:
  bool runs_away(const ContactStep &step, const Eigen::VectorXd &unknowns);

private:
  double last_ = 0;
  unsigned int n_standing_ = 0;
};
} // namespace orthocone
