// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

namespace orthocone
{
/// A rigid face that forces drive: m of its motions are not given, but what the contact forces must balance.
/// Its unknowns y are combinations of these motions that move the nodes by orthonormal columns, so that no
/// unit and no lever makes one of them dominate: rotations and translations move a far surface nearly alike.
class FreeFace
{
public:
  /// The face does not move by itself.
  FreeFace() = default;

  /// `motions`: 3 n x m, what a unit of each motion moves the nodes by. `balance`: m, what motions^T r must
  /// be. Throws std::invalid_argument if the motions are not independent.
  FreeFace(const Eigen::MatrixXd &motions, const Eigen::VectorXd &balance);

  Eigen::Index n() const { return columns_.cols(); }

  /// 3 n x m, orthonormal: displacement of the nodes by the unknowns.
  const Eigen::MatrixXd &columns() const { return columns_; }

  /// columns^T r - this vanishes in equilibrium, N.
  const Eigen::VectorXd &balance() const { return balance_; }

  /// The unknowns as motions, and back.
  Eigen::VectorXd motions(const Eigen::VectorXd &unknowns) const;
  Eigen::VectorXd unknowns(const Eigen::VectorXd &motions) const;

private:
  Eigen::MatrixXd columns_;
  Eigen::VectorXd balance_;
  Eigen::MatrixXd triangle_; ///< upper; motions of the nodes = columns triangle
};
} // namespace orthocone
