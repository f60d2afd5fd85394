// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The law of two ellipses as its source prints it: projection on the elliptic cone, and modified
// displacement. The methods `feng2006`, `box3` and `uzawa` iterate on it, and `newton` without a dense
// compliance has it for a rescue; all others know FrictionLaw.
// Vectors are in local axes (normal, x, y), where x and y are the axes of both ellipses. Forces r (N) act
// from the plane on the body; displacements d (mm) are the body's, relative to the plane. Source: Feng,
// Hjiaj, de Saxce, Mroz, Int. J. Non-Linear Mech. 41 (2006) 936-948, sections 2 and 3; docs/theory.md,
// section 1. Nothing throws.
#pragma once

#include <Eigen/Dense>

namespace orthocone
{
/// Semi-axes of the friction ellipse (mu) and of the slip ellipse (p), without units. With mu_x = mu_y = 0
/// there is no friction: the cone is the half-line r_t = 0, r_n >= 0, every node in contact slips, and p
/// means nothing.
struct OrthotropicFriction
{
  double mu_x;
  double mu_y;
  double p_x;
  double p_y;

  Eigen::Vector2d mu() const { return {mu_x, mu_y}; }
  Eigen::Vector2d p() const { return {p_x, p_y}; }
};

/// Whether there is no friction.
bool is_frictionless(const OrthotropicFriction &law);

/// Weights (p_x/mu_x)^2, (p_y/mu_y)^2 by which the slip direction departs from the normal of the cone: both
/// equal for associated slip (1 after normalized()), both 0 without friction. They are Q^2 of docs/theory.md,
/// section 1.
Eigen::Vector2d slip_weights(const OrthotropicFriction &law);

/// The same law with p scaled so that the larger slip weight is 1. The law does not depend on the length of
/// p, but the natural map does.
OrthotropicFriction normalized(const OrthotropicFriction &law);

/// ||r_t||_m = sqrt((r_x/mu_x)^2 + (r_y/mu_y)^2), N: the normal force at which r_t slips. Without friction it
/// is infinite unless r_t = 0.
double friction_norm(const OrthotropicFriction &law, double r_x, double r_y);

/// ||v_t||*_m = sqrt((mu_x v_x)^2 + (mu_y v_y)^2), dual to friction_norm(), in the unit of v.
double dual_norm(const OrthotropicFriction &law, double v_x, double v_y);

/// Nearest point of the cone K = { r : ||r_t||_m <= r_n }, N: docs/theory.md, section 1, "The elliptic cone".
Eigen::Vector3d project(const OrthotropicFriction &law, const Eigen::Vector3d &tau);

/// The nearest point of the cone (N) and the derivative of the projection there. On the surface, where a node
/// slips, the derivative is ray ray^T + stiffness side side^T with orthonormal vectors ray (along the
/// generator) and side (along the cone, across the generator); `normal` completes them and spans the kernel.
/// In the polar cone it vanishes, and in the cone it is the identity.
struct Projection
{
  enum class Zone
  {
    polar,   ///< projects on the apex: the node is open
    inside,  ///< projects on itself: the node sticks (never without friction)
    outside, ///< projects on the surface: the node slips
  };

  /// The rank of the derivative.
  int n_directions() const { return zone == Zone::polar ? 0 : zone == Zone::inside ? 3 : 2; }

  Zone zone = Zone::polar;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d ray = Eigen::Vector3d::Zero();
  Eigen::Vector3d side = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double stiffness = 0; ///< in (0, 1]; 0 without friction
};

/// The same point as project(), tau in N, with the derivative.
Projection project_with_derivative(const OrthotropicFriction &law, const Eigen::Vector3d &tau);

/// Modified displacement G(d) = (d_n + ||Q^2 d_t||*_m, Q^2 d_t), mm, of the present gap d_n and the slip d_t
/// since the last step. The law is r = project(r - rho G(d)) for any rho > 0 (N/mm): section 3 of the paper.
Eigen::Vector3d modified_displacement(const OrthotropicFriction &law, const Eigen::Vector3d &d);

/// Derivative of modified_displacement(), 3 x 3. At d_t = 0, where there is none, the slope of the norm is
/// taken as 0.
Eigen::Matrix3d modified_displacement_derivative(const OrthotropicFriction &law, const Eigen::Vector3d &d);

/// Direction in which a node slips under the tangential force (r_x, r_y), not normalized: -(r_x/p_x^2,
/// r_y/p_y^2).
Eigen::Vector2d slip_direction(const OrthotropicFriction &law, double r_x, double r_y);

/// Tangential force on the body per unit normal force, in steady slip along the direction (d_x, d_y) != 0 (a
/// vector of any length).
Eigen::Vector2d sliding_traction(const OrthotropicFriction &law, double d_x, double d_y);
} // namespace orthocone
