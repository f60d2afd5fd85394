// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/contact_problem.h>

namespace orthocone
{
/// Linearized natural map at given forces, reduced to the unknowns that matter: none for an open node, three
/// for a stuck one, two (along and across the generator of the cone) for a slipping one, whose third
/// component the linearization fixes.
class NewtonSystem
{
public:
  /// `displacement` belongs to `force`; the problem needs its dense compliance.
  NewtonSystem(const ContactProblem &problem, const NodeVector &force, const NodeVector &displacement);

  /// Newton's change of the forces. Not finite if the matrix is singular or itself not finite.
  NodeVector solve() const;

private:
  /// What the linearization says of one node. The change of force is fixed + basis * unknowns; the equations
  /// are rows^T (change of displacement) + diagonal * unknowns = right_side.
  struct Node
  {
    Eigen::Index first = 0; ///< number of its first unknown
    Eigen::Index n_unknowns = 0;
    Eigen::Matrix3d basis = Eigen::Matrix3d::Zero(); ///< first n_unknowns columns count
    Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();  ///< likewise
    Eigen::Vector3d fixed = Eigen::Vector3d::Zero();
    Eigen::Vector3d diagonal = Eigen::Vector3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
  };

  Node linearize(Eigen::Index node, const Eigen::Vector3d &force, const Eigen::Vector3d &displacement) const;
  Eigen::MatrixXd matrix() const;
  Eigen::VectorXd right_side() const;

  const ContactProblem &problem_;
  std::vector<Node> nodes_;
  Eigen::Index n_unknowns_ = 0;
};
} // namespace orthocone
