// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/backends/factorized_body.h>
#include <orthocone/scene/options.h>
#include <orthocone/surface/mortar.h>

#include <memory>

namespace orthocone
{
/// The elastic body that the upper one is pressed on, and the motion of its surface at the upper body's n
/// contact nodes (docs/theory.md, section 2, "A second elastic body below"). Below a surface with the normal
/// z it is computed as its mirror image about z = 0, which stands on the plane as the upper body does: a
/// force r of a contact node presses the image alike and draws it the other way. Bodies with normals of their
/// own lie in their places. Names with `own` belong to the body as it is computed, in axes (z, x, y) at its
/// own m contact nodes.
class LowerBody
{
public:
  /// `surface` and `axes` are the upper body's. Wall times are added to `seconds`. Throws InputError where
  /// the lower surface does not lie under all of the upper one, and what FactorizedBody throws.
  LowerBody(const Parameters &parameters, const ModelSymmetry &symmetry, const ContactSurface &surface,
            const LocalAxes &axes, PhaseSeconds &seconds);
  LowerBody(const LowerBody &) = delete; // its modules refer to each other
  LowerBody &operator=(const LowerBody &) = delete;

  const ElasticBody &body() const { return *body_; }

  /// How its faces find those of the upper body.
  Facing facing() const { return facing_; }

  /// Depth of its surface below z = 0 at the contact nodes, or its distance along their normals (3 n, mm):
  /// the first of three numbers is its part of the gap.
  const NodeVector &gaps() const { return gaps_; }

  /// Local axes of its own nodes: z, x, y.
  static const LocalAxes &own_axes();

  /// Forces of the contact nodes (3 n) as forces on its own nodes (3 m), N.
  NodeVector own_force(const NodeVector &force) const { return map_.transpose() * force; }

  /// The part of the gap and slip of the contact nodes (3 n) that displacements of its own nodes (3 m) cause,
  /// mm.
  NodeVector parted(const NodeVector &own_displacement) const { return map_ * own_displacement; }

  /// Its compliance at the contact nodes: 3 n x 3 n, mm/N, symmetric and positive semidefinite.
  Eigen::MatrixXd compliance() const;

private:
  Facing facing_;
  std::shared_ptr<const FactorizedBody> body_; ///< other scenes may have it, too
  Eigen::SparseMatrix<double> seen_;           ///< MortarMap::map, n x m
  Eigen::SparseMatrix<double> map_;            ///< 3 n x 3 m
  NodeVector gaps_;
};

/// The part of the lower surface in the gaps of the n contact nodes of both meshed bodies, mm. Throws
/// InputError where the lower surface does not lie under all of the upper one.
Eigen::VectorXd lower_distances(const Parameters &parameters, const ModelSymmetry &symmetry,
                                const ContactSurface &surface, const ContactSurface &own);

/// Throws InputError where a lower body does not lie under all of the upper one. It makes both meshes, and
/// factorizes nothing.
void require_cover(const Parameters &parameters, const ModelSymmetry &symmetry);
} // namespace orthocone
