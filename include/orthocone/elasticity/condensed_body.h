// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/compliance/compliance.h>
#include <orthocone/elasticity/body_unknowns.h>
#include <orthocone/elasticity/stiffness.h>
#include <orthocone/elasticity/stiffness_factor.h>

namespace orthocone
{
/// Local axes of the contact surface: normal z, and tangents x, y turned about it.
class SurfaceAxes
{
public:
  /// `angle` in degrees from the global to the local x axis. Multiples of 90 degrees turn without rounding.
  explicit SurfaceAxes(double angle);

  Eigen::Vector2d to_local(const Eigen::Vector2d &global) const { return turn_.transpose() * global; }
  Eigen::Vector2d to_global(const Eigen::Vector2d &local) const { return turn_ * local; }

  /// Row d: the global direction d (x, y, z) in local components (normal, x, y).
  Eigen::Matrix3d global_in_local() const;

private:
  Eigen::Matrix2d turn_;
};

/// The body as its contact nodes feel it. The displacement under a motion of the top and contact forces r is
/// that rigid motion plus K^-1 r, because the rest of the body is free: the plane alone keeps it from
/// following the top.
class CondensedBody
{
public:
  CondensedBody(const BodyUnknowns &unknowns, const StiffnessFactor &factor, const SurfaceAxes &axes);

  const DenseCompliance &compliance() const { return compliance_; }

  /// Displacement (normal, x, y) of every contact node, without contact forces, when the top moves by `top`
  /// (ux, uy, uz).
  NodeVector free_displacement(const std::array<double, 3> &top) const;

  /// Displacement of all degrees of freedom under that motion and the contact forces `force` (local axes, N).
  Eigen::VectorXd volume_displacement(const std::array<double, 3> &top, const NodeVector &force) const;

  /// Its two parts: K^-1 r of the free unknowns, and the motion added to it.
  Eigen::VectorXd elastic_displacement(const NodeVector &force) const;
  Eigen::VectorXd with_motion(const std::array<double, 3> &top, const Eigen::VectorXd &elastic) const;

  /// How far body and condensed body differ under contact forces `force` that move the contact nodes by
  /// `elastic` (without the motion of the top). Rounding is kept well below `bound`.
  struct Mismatch
  {
    double unbalanced;      ///< ||K u - r|| / ||r|| over all free unknowns, with u = K^-1 r
    double displacement;    ///< largest difference between u and `elastic` on the contact surface, mm
    Eigen::VectorXd volume; ///< u
  };
  Mismatch mismatch(const Stiffness &stiffness, const NodeVector &force, const NodeVector &elastic,
                    double bound) const;

private:
  Eigen::VectorXd on_free_unknowns(const NodeVector &force) const;
  Eigen::MatrixXd local_compliance(const Eigen::MatrixXd &inverse) const;

  const BodyUnknowns &unknowns_;
  const StiffnessFactor &factor_;
  SurfaceAxes axes_;
  DenseCompliance compliance_;
};
} // namespace orthocone
