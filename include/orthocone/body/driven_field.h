// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/backends/contact_frame.h>
#include <orthocone/body/body.h>
#include <orthocone/surface/rigid_motion.h>

#include <functional>

namespace orthocone
{
/// What drives a body beside contact forces, without these: the 6 components of its held face (a unit is 1 mm
/// or 1 rad), and behind them its m loads (a unit is 1 MPa, mm or K). All is linear, so that there is one
/// column for each of them; those of the face are what supports add to its rigid motion, and a load on the
/// other body has a column of zeros. A body without supports and loads follows its face as a rigid one, and
/// has no such field.
struct DrivenField
{
  Eigen::MatrixXd volume;  ///< added to all degrees of freedom that this process knows, n_dofs x (6 + m), mm
  Eigen::MatrixXd contact; ///< added at the n contact nodes in their local axes, 3 n x (6 + m), mm

  /// The conjugates of face and loads without contact forces, (6 + m) x (6 + m), of the model without its
  /// copies: the wrench on the held face, and Conjugate of each load. Its symmetric part is that of the
  /// elastic energy.
  Eigen::MatrixXd conjugates;

  /// For each column 1 where it gives displacements or strains, so that contact forces act against it, and -1
  /// where it gives tractions.
  Eigen::VectorXd signs;

  Eigen::VectorXd areas; ///< of the surfaces of the m loads, of the model, mm^2
};

/// Computes the field by `solve`, which maps forces on the n_free() free degrees of freedom of this process
/// (N) to their displacements (mm). All processes must call it. Motions that the symmetry does not have get
/// columns of zeros. Throws what `solve` throws.
DrivenField driven_field(const Body &body, const BodyOptions &options, const ContactFrame &frame,
                         const ModelSymmetry &symmetry,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd &forces)> &solve);

/// Displacements (mm) of the n contact nodes in their local axes, 3 n x m, out of m displacements of all
/// degrees of freedom that this process knows, n_dofs x m. All processes must call it.
Eigen::MatrixXd at_contact_nodes(const ContactFrame &frame, const Eigen::MatrixXd &volume);

/// The names of two loads that move the same nodes along the same axis, as on surfaces that meet at an edge,
/// in the words "a and b along x"; "" where there are none. All processes must call it.
std::string moved_twice(const Body &body, const GeometryOptions &geometry);

/// Whether the body has supports or loads, of which it does not follow its face alone. All processes must
/// call it.
bool is_driven(const Body &body, const BodyOptions &options);
} // namespace orthocone
