// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/backends/contact_frame.h>
#include <orthocone/body/body.h>
#include <orthocone/surface/rigid_motion.h>

#include <functional>

namespace orthocone
{
/// What the motion of the held face does to a body whose supports do not follow it, without contact forces.
/// It is linear in the motion, so that there is one column for each of the 6 components (a unit is 1 mm or 1
/// rad). The body is displaced by the rigid motion of the face and by what this adds to it. A body without
/// supports follows its face as a rigid one, and has no such field.
struct DrivenField
{
  Eigen::MatrixXd volume;  ///< added to all degrees of freedom that this process knows, n_dofs x 6, mm
  Eigen::MatrixXd contact; ///< added at the n contact nodes in their local axes, 3 n x 6, mm

  /// Wrench on the held face that a motion takes against the supports, of the model without its copies:
  /// symmetric and positive semidefinite, N/mm, N and N mm.
  Eigen::Matrix<double, n_rigid_components, n_rigid_components> stiffness;
};

/// Computes the field by `solve`, which maps forces on the n_free() free degrees of freedom of this process
/// (N) to their displacements (mm). All processes must call it. Motions that the symmetry does not have get
/// columns of zeros. Throws what `solve` throws.
DrivenField driven_field(const Body &body, const ContactFrame &frame, const ModelSymmetry &symmetry,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd &forces)> &solve);
} // namespace orthocone
