// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

namespace orthocone
{
/// A rigid face that forces drive: instead of m of its motions, the forces and moments are given that the
/// contact forces must balance (docs/theory.md, section 3, "Forces that drive the held face"). Its unknowns y
/// (mm) are combinations of these motions that move the nodes by orthonormal columns, so that neither a unit
/// nor a lever makes one of them dominate: rotations and translations move a far surface nearly alike.
class FreeFace
{
public:
  /// A face that does not move by itself: m = 0.
  FreeFace() = default;

  /// `motions`: 3 n x m, how far a unit of each motion (mm or rad) moves the nodes, mm. `balance`: size m,
  /// what motions^T r must be (N or N mm). Where the body itself resists its motion m, because supports hold
  /// it, the balance is motions^T r - stiffness m: m x m, symmetric and positive semidefinite. Throws
  /// std::invalid_argument if the motions are not independent.
  FreeFace(const Eigen::MatrixXd &motions, const Eigen::VectorXd &balance,
           const Eigen::MatrixXd &stiffness = {});

  Eigen::Index n() const { return columns_.cols(); } ///< m

  /// C, 3 n x m, orthonormal: C y is the displacement of the nodes (mm).
  const Eigen::MatrixXd &columns() const { return columns_; }

  /// The value of C^T r - S y in equilibrium: size m, N.
  const Eigen::VectorXd &balance() const { return balance_; }

  /// S, m x m, N/mm; empty where contact forces alone resist the motion.
  const Eigen::MatrixXd &stiffness() const { return stiffness_; }
  bool has_stiffness() const { return stiffness_.size() > 0; }

  /// The m unknowns (mm) as motions (mm and rad), and back.
  Eigen::VectorXd motions(const Eigen::VectorXd &unknowns) const;
  Eigen::VectorXd unknowns(const Eigen::VectorXd &motions) const;

private:
  Eigen::MatrixXd columns_;
  Eigen::VectorXd balance_;
  Eigen::MatrixXd stiffness_;
  Eigen::MatrixXd triangle_; ///< upper; motions of the nodes = columns triangle
};
} // namespace orthocone
