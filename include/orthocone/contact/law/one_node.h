// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/friction_law.h>

namespace orthocone
{
/// The contact problem of one node with the forces of all others fixed: relative displacement d = q + W r.
/// W symmetric positive definite; its inverse is kept because sweeps solve with it again and again.
struct OneNodeProblem
{
  OrthotropicFriction law;
  Eigen::Matrix3d compliance;
  Eigen::Matrix3d stiffness; ///< inverse of `compliance`
};

/// Exact solution r of the law for d = q + W r: open if q_n >= 0; stick if -W^-1 q lies in the cone;
/// otherwise slip, where d_n = 0 and the slip rule leave one equation for the angle of the force on the
/// friction ellipse. `guess` is the force of the last sweep: of several slip solutions the one next to it is
/// taken.
Eigen::Vector3d solve_one_node(const OneNodeProblem &problem, const Eigen::Vector3d &q,
                               const Eigen::Vector3d &guess);
} // namespace orthocone
