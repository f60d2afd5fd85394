// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/friction_law.h>

namespace orthocone
{
/// The contact problem of one node with the forces of all others fixed: its relative displacement is d = q +
/// W r (mm). W of a body is symmetric and positive definite. If others slip with the node, it is not, and
/// must be invertible. Its inverse is kept because every sweep needs it.
struct OneNodeProblem
{
  Eigen::Matrix3d compliance; ///< W, mm/N
  Eigen::Matrix3d stiffness;  ///< inverse of `compliance`, N/mm
};

/// Exact solution r (N) of the law for d = q + W r, q in mm. The node is open if q_n >= 0 and sticks if -W^-1
/// q lies in the cone. Otherwise it slips: d_n = 0 and the slip rule leave one equation for the angle of the
/// reduced force (docs/theory.md, section 3, `gauss-seidel`). `guess` is the force of the
/// last sweep (N): if there are several slip solutions, the one nearest to it is taken. Throws nothing.
Eigen::Vector3d solve_one_node(const FrictionLaw &law, const OneNodeProblem &problem,
                               const Eigen::Vector3d &q, const Eigen::Vector3d &guess);
} // namespace orthocone
