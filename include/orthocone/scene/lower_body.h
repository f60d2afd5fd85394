// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/backends/factorized_body.h>
#include <orthocone/surface/mortar.h>

namespace orthocone
{
/// The elastic body that another one is pressed on, and how its surface moves at the contact nodes of that
/// one. It is computed as its mirror image about z = 0, which stands on the plane as the other one does:
/// there a force r of a contact node presses alike and draws the other way. Where names say `own`, they are
/// of that image, in axes (z, x, y) at its own contact nodes.
class LowerBody
{
public:
  /// On the contact nodes of the other body, in their axes. Wall times are added to `seconds`. Throws
  /// InputError where its surface does not lie under all of the other's, std::runtime_error if its stiffness
  /// cannot be factorized.
  LowerBody(const Parameters &parameters, const ModelSymmetry &symmetry, const ContactSurface &surface,
            const LocalAxes &axes, PhaseSeconds &seconds);
  LowerBody(const LowerBody &) = delete; // its modules refer to each other
  LowerBody &operator=(const LowerBody &) = delete;

  const ElasticBody &body() const { return body_; }

  /// Depth of its surface below z = 0 at the contact nodes, mm: three a node, the first its part of the gap.
  const NodeVector &gaps() const { return gaps_; }

  /// What forces of the contact nodes are at its own, N.
  NodeVector own_force(const NodeVector &force) const { return map_.transpose() * force; }

  /// Part of the gap and slip of the contact nodes that displacements of its own nodes make, mm.
  NodeVector parted(const NodeVector &own_displacement) const { return map_ * own_displacement; }

  /// 3 n x 3 n, mm/N: symmetric, not negative.
  Eigen::MatrixXd compliance() const;

private:
  FactorizedBody body_;
  Eigen::SparseMatrix<double> map_; ///< 3 n x 3 m
  NodeVector gaps_;
};
} // namespace orthocone
