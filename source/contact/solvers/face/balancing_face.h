// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>

namespace orthocone
{
/// A face that forces drive, as sweeps over the nodes see it: a spring. During a sweep its length follows
/// what the face lacks of its balance; after the sweep this length becomes motion of the face. To the nodes
/// the spring is a compliance of rank m, as soft as the body; at the solution it carries nothing.
/// docs/theory.md, section 3.
class BalancingFace
{
public:
  /// `unknowns`: those of the step at the beginning of the sweep.
  BalancingFace(const ContactStep &step, const Eigen::VectorXd &unknowns);

  /// How far the face and its spring move a node now, mm.
  Eigen::Vector3d displacement(Eigen::Index node) const;

  /// The spring's part in a node's compliance, mm/N.
  Eigen::Matrix3d compliance(Eigen::Index node) const;

  /// To be called when a node's force changes, N.
  void add(Eigen::Index node, const Eigen::Vector3d &change);

  /// Motion of the face after the sweep: size m, mm.
  Eigen::VectorXd motion() const { return motion_ + follows(imbalance_); }

private:
  /// How the face follows what is out of balance, mm.
  Eigen::VectorXd follows(const Eigen::VectorXd &force) const
  {
    return compliance_.size() > 0 ? Eigen::VectorXd(compliance_ * force) : Eigen::VectorXd(softness_ * force);
  }

  const Eigen::MatrixXd &columns_;
  double softness_;            ///< of the spring, mm/N
  Eigen::MatrixXd compliance_; ///< of the spring beside what resists the face itself, m x m, or empty
  Eigen::VectorXd motion_;
  Eigen::VectorXd imbalance_;
};

/// Whether forces drive the face, are out of balance, and meet no resistance: no node sticks
/// that it would move, and if all are open the face moves off. An iteration that does not converge then has a
/// load at the limit of what friction carries, or beyond.
bool nothing_holds(const ContactStep &step, const Eigen::VectorXd &unknowns);

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
