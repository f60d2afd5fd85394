// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <vector>

namespace orthocone
{
#ifdef ORTHOCONE_EIGEN_ALIGNMENT
// Of an installed library: Eigen frees memory in another way where it is compiled for wider registers.
static_assert(EIGEN_DEFAULT_ALIGN_BYTES == ORTHOCONE_EIGEN_ALIGNMENT,
              "compile for the processor that orthocone was compiled for, without -march=native");
#endif

/// Vectors over the contact nodes hold three numbers a node, in local axes: normal, x, y.
using NodeVector = Eigen::VectorXd;

/// What Newton's method wants of a contact node: its change of force is fixed + basis x with n unknowns x,
/// and n equations hold, rows^T (change of displacement) + diagonal x = right_side. No unknowns: the force is
/// given. Three: the displacement is. Two: a mixed relation, first along what is stiff, then along what
/// friction makes soft.
struct NodeCondition
{
  Eigen::Index n_unknowns = 0;                     ///< 0, 2 or 3; as many columns of the next two count
  Eigen::Matrix3d basis = Eigen::Matrix3d::Zero(); ///< orthonormal columns
  Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();  ///< N/mm
  Eigen::Vector3d diagonal = Eigen::Vector3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero(); ///< N
  Eigen::Vector3d fixed = Eigen::Vector3d::Zero();      ///< N
};

/// The conditions of all nodes, and of a face that is free to move: it moves the nodes by face y, and the
/// change of force must obey face^T (change of force) = face_right_side.
struct ContactConditions
{
  std::vector<NodeCondition> nodes;
  Eigen::MatrixXd face;            ///< 3 n x m, orthonormal columns; no columns: the face does not move
  Eigen::VectorXd face_right_side; ///< m, N
  Eigen::VectorXd rest{};          ///< BodyPart::rest of the present state
};

/// What stands behind contact nodes where no dense compliance does: the displacement of all free degrees of
/// freedom of the body (mm) that this process has, and the forces (N) that they lack of their equilibrium.
/// Else both are empty.
struct BodyPart
{
  Eigen::VectorXd displacement{};
  Eigen::VectorXd rest{};

  /// This and a share of a change.
  BodyPart moved(const double share, const BodyPart &change) const
  {
    if (change.rest.size() == 0)
      return *this;
    BodyPart result{share * change.displacement, share * change.rest};
    if (rest.size() > 0)
    {
      result.displacement += displacement;
      result.rest += rest;
    }
    return result;
  }
};

/// Changes of the forces, of the motion y of the face, of the displacement and of the body behind it.
struct ContactChange
{
  NodeVector force{};        ///< N
  Eigen::VectorXd face{};    ///< mm
  NodeVector displacement{}; ///< with the motion of the face, mm; nothing: as the compliance says
  BodyPart body{};
};

/// Solves for what a linearized contact law wants, by whatever means a body has: the cut between the law and
/// the linear algebra behind it.
class ConditionSolver
{
public:
  virtual ~ConditionSolver() = default;

  /// Up to a relative error `accuracy`, or what can be had. Not finite if the system is singular.
  virtual ContactChange solve(const ContactConditions &conditions, double accuracy) const = 0;
};
} // namespace orthocone
