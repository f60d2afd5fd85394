// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body_unknowns.h>
#include <orthocone/surface/condition_solver.h>
#include <orthocone/surface/local_axes.h>
#include <orthocone/surface/rigid_motion.h>

namespace orthocone
{
/// The n contact nodes of a body in their local axes: converts motions of the held face and contact forces
/// into unknowns of the body, and back. It is the same for every backend, and throws nothing.
class ContactFrame
{
public:
  /// `unknowns` must outlive the frame.
  ContactFrame(const BodyUnknowns &unknowns, LocalAxes axes);

  const std::vector<ContactNode> &nodes() const { return unknowns_.contact_surface().nodes; }
  unsigned int n_free() const { return unknowns_.n_free(); }

  /// 3 x 3; row d is the global direction d (x, y, z) in local components (normal, x, y) of the node.
  const Eigen::Matrix3d &global_in_local(const std::size_t node) const { return axes_.global_in_local(node); }

  /// ElasticBody::moved_with(), wrench() and with_motion(); `elastic` may also have all local degrees of
  /// freedom.
  NodeVector moved_with(const RigidMotion &held) const;
  Wrench wrench(const NodeVector &force) const;
  Eigen::VectorXd with_motion(const RigidMotion &held, const Eigen::VectorXd &elastic) const;

  /// Contact forces (3 n, N) as forces on the n_free() free degrees of freedom of this process.
  Eigen::VectorXd on_free_unknowns(const NodeVector &force) const;

  /// Largest difference (mm, over all processes) between displacements of the contact nodes (3 n) and the
  /// displacements of the free degrees of freedom there (n_free()).
  double difference(const NodeVector &displacement, const Eigen::VectorXd &free) const;

private:
  const BodyUnknowns &unknowns_;
  LocalAxes axes_;
};
} // namespace orthocone
