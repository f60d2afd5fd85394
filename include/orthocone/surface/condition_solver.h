// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <Eigen/Dense>

#include <vector>

namespace orthocone
{
#ifdef ORTHOCONE_EIGEN_ALIGNMENT
// For users of the installed library: Eigen frees memory in another way where it is compiled for wider
// registers.
static_assert(EIGEN_DEFAULT_ALIGN_BYTES == ORTHOCONE_EIGEN_ALIGNMENT,
              "compile for the processor that orthocone was compiled for, without -march=native");
#endif

/// Vectors over the contact nodes hold three numbers a node, in local axes: normal, x, y.
using NodeVector = Eigen::VectorXd;

/// A linearized contact law at one node. Its change of force (N) is fixed + basis x with n unknowns x (N),
/// which obey n equations: rows^T (change of displacement, mm) + diagonal x = right_side. Without unknowns
/// the force is given. With three the displacement is given, and basis is I. With two there is a mixed
/// relation: its first unknown is along the stiff direction, its second one along the direction that friction
/// makes soft. docs/theory.md, section 3, "A body without a matrix".
struct NodeCondition
{
  Eigen::Index n_unknowns = 0;                     ///< 0, 2 or 3; as many columns of the next two count
  Eigen::Matrix3d basis = Eigen::Matrix3d::Zero(); ///< columns of length 1
  Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();  ///< N/mm
  Eigen::Vector3d diagonal = Eigen::Vector3d::Zero();
  Eigen::Vector3d right_side = Eigen::Vector3d::Zero(); ///< N
  Eigen::Vector3d fixed = Eigen::Vector3d::Zero();      ///< N
};

/// The conditions of all n nodes, and of a face that is free to move: its m unknowns y (mm) move the nodes by
/// face y, and the change of force must obey face^T (change of force) - S y = face_right_side.
struct ContactConditions
{
  std::vector<NodeCondition> nodes;
  Eigen::MatrixXd face;             ///< 3 n x m, orthonormal columns; no columns: the face does not move
  Eigen::VectorXd face_right_side;  ///< m, N
  Eigen::MatrixXd face_stiffness{}; ///< S, m x m, N/mm, or empty: nothing but the nodes resists y
  Eigen::VectorXd residual{};       ///< BodyPart::residual of the present state
};

/// The body behind the contact nodes, where no dense compliance replaces it: displacement (mm) of all free
/// degrees of freedom that this process has, and the forces (N) that they lack of their equilibrium. With a
/// dense compliance both are empty.
struct BodyPart
{
  Eigen::VectorXd displacement{};
  Eigen::VectorXd residual{};

  /// This part, moved by a share of a change. A change that is empty changes nothing.
  BodyPart moved(const double share, const BodyPart &change) const
  {
    if (change.residual.size() == 0)
      return *this;
    BodyPart result{share * change.displacement, share * change.residual};
    if (residual.size() > 0)
    {
      result.displacement += displacement;
      result.residual += residual;
    }
    return result;
  }
};

/// Changes of the forces (3 n), of the motion y of the face (m), of the displacement (3 n) and of the body
/// behind it.
struct ContactChange
{
  NodeVector force{};        ///< N
  Eigen::VectorXd face{};    ///< mm
  NodeVector displacement{}; ///< with the motion of the face, mm; if empty, what the compliance gives
  BodyPart body{};
};

/// Solves the conditions of a linearized contact law by whatever means a body has: the interface between the
/// law and the linear algebra behind it.
class ConditionSolver
{
public:
  virtual ~ConditionSolver() = default;

  /// The change, up to a relative error `accuracy` or the best that can be reached. Not finite if the system
  /// is singular. Throws SolveError where the body cannot be solved.
  virtual ContactChange solve(const ContactConditions &conditions, double accuracy) const = 0;
};
} // namespace orthocone
