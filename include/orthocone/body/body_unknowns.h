// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/hanging_dofs.h>
#include <orthocone/surface/contact_surface.h>

#include <Eigen/Dense>

namespace orthocone
{
/// Numbers of cells and degrees of freedom of a body, over all processes.
struct BodySize
{
  unsigned int cells = 0;
  unsigned int dofs = 0;
  unsigned int free_dofs = 0;
};

/// What condensation, checks and reports need to know of a body, whatever its mesh: its contact surface, and
/// its degrees of freedom in four ranges: interior (free, not on the contact surface), contact (free, on the
/// contact surface), held (zero) and hanging (moved by others). Where several processes share a body, a
/// process has the degrees of freedom that it owns in these ranges, and behind them the others that it works
/// with.
class BodyUnknowns
{
public:
  /// Including degrees of freedom that other processes own.
  unsigned int n_dofs() const { return directions_.size(); }
  unsigned int n_owned() const { return n_owned_; }       ///< all four ranges
  unsigned int n_interior() const { return n_interior_; } ///< the first range
  unsigned int n_free() const { return n_free_; }         ///< the first two ranges

  const BodySize &size() const { return size_; }

  /// Direction in which a degree of freedom moves, 0: x (r in an axisymmetric body), 1: y, 2: z.
  unsigned int direction(const unsigned int dof) const { return directions_[dof]; }

  /// Place of a degree of freedom (x, y, z), mm; in an axisymmetric body it is in the plane y = 0. Rigid
  /// motions need it.
  Eigen::Vector3d position(const unsigned int dof) const { return positions_.col(dof); }

  /// Centroid of the whole held face, mm.
  const Eigen::Vector3d &held_centre() const { return held_centre_; }

  /// Vector from the centre of the held face to a contact node, mm.
  Eigen::Vector3d arm(const ContactNode &node) const { return node.place() - held_centre_; }

  const ContactSurface &contact_surface() const { return contact_surface_; }

  const HangingDofs &hanging() const { return hanging_; }

  /// Components of the rigid motion that nothing holds but contact, because there is no held face: forces of
  /// zero drive them.
  const std::vector<unsigned int> &loose_components() const { return loose_components_; }

protected:
  BodySize size_;
  unsigned int n_interior_ = 0;
  unsigned int n_free_ = 0;
  unsigned int n_owned_ = 0;
  std::vector<unsigned char> directions_;
  Eigen::Matrix3Xd positions_; ///< of the degrees of freedom, mm
  Eigen::Vector3d held_centre_ = Eigen::Vector3d::Zero();
  ContactSurface contact_surface_;
  HangingDofs hanging_;
  std::vector<unsigned int> loose_components_;
};
} // namespace orthocone
