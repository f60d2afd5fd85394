// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/backends/stiffness_factor.h>
#include <orthocone/body/body_unknowns.h>
#include <orthocone/body/elastic_body.h>
#include <orthocone/body/fe/stiffness.h>
#include <orthocone/surface/compliance.h>
#include <orthocone/surface/local_axes.h>
#include <orthocone/surface/rigid_motion.h>

namespace orthocone
{
/// The body as its contact nodes feel it. The displacement under a motion of the held face and contact forces
/// r is that rigid motion plus K^-1 r, because the rest of the body is free: the plane alone keeps it from
/// following it.
class CondensedBody
{
public:
  CondensedBody(const BodyUnknowns &unknowns, const StiffnessFactor &factor, LocalAxes axes);

  const DenseCompliance &compliance() const { return compliance_; }

  /// Displacement (normal, x, y; mm) of every contact node, without contact forces, when the held face moves
  /// by `held` about its centre.
  NodeVector moved_with(const RigidMotion &held) const;

  /// Wrench about the centre of the held face (N, N mm) of the contact forces `force` (local axes, N) on the
  /// nodes of the modelled part, without its copies. It does the work on a motion of the held face that the
  /// forces do on moved_with() this motion.
  Wrench wrench(const NodeVector &force) const;

  /// Displacement of all degrees of freedom under that motion and the contact forces `force` (local axes, N).
  Eigen::VectorXd volume_displacement(const RigidMotion &held, const NodeVector &force) const;

  /// Its two parts: K^-1 r of the free unknowns, and the motion added to it.
  Eigen::VectorXd elastic_displacement(const NodeVector &force) const;
  Eigen::VectorXd with_motion(const RigidMotion &held, const Eigen::VectorXd &elastic) const;

  /// ElasticBody::mismatch().
  BodyMismatch mismatch(const Stiffness &stiffness, const NodeVector &force, const NodeVector &elastic,
                        double bound) const;

private:
  Eigen::VectorXd on_free_unknowns(const NodeVector &force) const;
  Eigen::MatrixXd local_compliance(const Eigen::MatrixXd &inverse) const;

  const BodyUnknowns &unknowns_;
  const StiffnessFactor &factor_;
  LocalAxes axes_;
  DenseCompliance compliance_;
};
} // namespace orthocone
