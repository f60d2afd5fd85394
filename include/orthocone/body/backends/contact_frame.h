// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body_unknowns.h>
#include <orthocone/surface/condition_solver.h>
#include <orthocone/surface/local_axes.h>
#include <orthocone/surface/rigid_motion.h>

namespace orthocone
{
/// The contact nodes of a body in their local axes: what motions of the held face and contact forces are in
/// the unknowns of the body, and back. It is the same for every backend.
class ContactFrame
{
public:
  /// `unknowns` must outlive the frame.
  ContactFrame(const BodyUnknowns &unknowns, LocalAxes axes);

  const std::vector<ContactNode> &nodes() const { return unknowns_.contact_surface().nodes; }
  unsigned int n_free() const { return unknowns_.n_free(); }

  /// Row d: the global direction d (x, y, z) in local components (normal, x, y) of the node.
  Eigen::Matrix3d global_in_local(const std::size_t node) const { return axes_.global_in_local(node); }

  /// ElasticBody::moved_with(), wrench(), with_motion(); `elastic` may have all local degrees of freedom.
  NodeVector moved_with(const RigidMotion &held) const;
  Wrench wrench(const NodeVector &force) const;
  Eigen::VectorXd with_motion(const RigidMotion &held, const Eigen::VectorXd &elastic) const;

  /// Contact forces (N) as forces on the free degrees of freedom of this process.
  Eigen::VectorXd on_free_unknowns(const NodeVector &force) const;

  /// Largest difference between displacements of the contact nodes and those of the free degrees of freedom,
  /// mm, of all processes.
  double difference(const NodeVector &displacement, const Eigen::VectorXd &free) const;

private:
  const BodyUnknowns &unknowns_;
  LocalAxes axes_;
};
} // namespace orthocone
