// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "inner_compliance.h"

#include <orthocone/contact/contact_problem.h>

namespace orthocone
{
/// Linearized natural map at given forces, reduced to the unknowns that matter: none for an open node, three
/// for a stuck one, two (along and across the generator of the cone) for a slipping one, whose third
/// component the linearization fixes.
class NewtonSystem
{
public:
  /// `displacement` belongs to `force`; the map is the one with `rho_factor` times the rho of the problem.
  NewtonSystem(const ContactProblem &problem, const NodeVector &force, const NodeVector &displacement,
               double rho_factor = 1);

  /// Norm of that natural map, N.
  double error() const { return error_; }

  /// Newton's change of the forces, up to a relative error `tolerance` or what can be had in single
  /// precision. Not finite if the system is not.
  NodeVector solve(const InnerCompliance &compliance, float tolerance) const;

private:
  /// What the linearization says of one node. The change of force is fixed + basis * unknowns; the equations
  /// are rows^T (change of displacement) + diagonal * unknowns = right_side.
  struct Node
  {
    ConeZone zone = ConeZone::polar;
    Eigen::Index first = 0;                          ///< number of its first unknown
    Eigen::Matrix3f basis = Eigen::Matrix3f::Zero(); ///< first n_unknowns() columns count
    Eigen::Matrix3f rows = Eigen::Matrix3f::Zero();  ///< likewise; 1/mm, times the scale of the compliance
    Eigen::Matrix3f from_rows = Eigen::Matrix3f::Zero(); ///< of a stuck node: inverse of rows^T
    Eigen::Vector3d fixed = Eigen::Vector3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    float diagonal = 0; ///< of the unknown across the generator
    float across = 1;   ///< diagonal entry of the system there

    Eigen::Index n_unknowns() const { return zone == ConeZone::polar ? 0 : zone == ConeZone::inside ? 3 : 2; }
  };

  Node linearize(Eigen::Index node, double rho, const Eigen::Vector3d &force,
                 const Eigen::Vector3d &displacement);
  Eigen::VectorXd right_side(const InnerCompliance &compliance) const;
  Eigen::VectorXf apply(const InnerCompliance &compliance, const Eigen::VectorXf &unknowns) const;
  Eigen::VectorXf precondition(const InnerCompliance &compliance, const Eigen::VectorXf &rest) const;

  const ContactProblem *problem_;
  std::vector<Node> nodes_;
  Eigen::Index n_unknowns_ = 0;
  double error_ = 0;
};
} // namespace orthocone
