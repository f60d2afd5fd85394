// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/law/elliptic_cone.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orthocone
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr unsigned int most_newton_steps = 200;

/// Entries of vectors between these, and coefficients between their counterparts below, have squares and
/// quotients within the range of double.
constexpr double least_moderate = 1e-30;
constexpr double largest_moderate = 1e30;
constexpr double least_coefficient = 1e-50;
constexpr double largest_coefficient = 1e50;

/// Length of (x, y), whatever its squares do.
double length(const double x, const double y)
{
  const double square = x * x + y * y;
  const bool is_sure = square >= least_moderate && square <= largest_moderate;
  return is_sure ? std::sqrt(square) : std::hypot(x, y);
}

/// The largest entry of a vector that is so large or small that its squares leave the range of double;
/// else 1.
double unit_of(const Vector3d &tau)
{
  const double size = tau.cwiseAbs().maxCoeff();
  const bool is_extreme = size < least_moderate || size > largest_moderate;
  return is_extreme && size > 0 && std::isfinite(size) ? size : 1;
}

/// Tangential part of the nearest point for the multiplier lambda: r_i = tau_i / (1 + lambda / mu_i^2).
Vector2d tangential_point(const OrthotropicFriction &law, const Vector3d &tau, const double lambda)
{
  return {tau[1] / (1 + lambda / (law.mu_x * law.mu_x)), tau[2] / (1 + lambda / (law.mu_y * law.mu_y))};
}

/// d/dlambda of ||r_t(lambda)||_m.
double norm_slope(const OrthotropicFriction &law, const Vector2d &r, const double norm, const double lambda)
{
  const double x = law.mu_x * law.mu_x;
  const double y = law.mu_y * law.mu_y;
  return -(r[0] * r[0] / (x * (x + lambda)) + r[1] * r[1] / (y * (y + lambda))) / norm;
}

/// Multiplier of the nearest point for tau outside the cone and its polar: the only root of the decreasing
/// function psi(lambda) = ||r_t(lambda)||_m (1 - lambda) - tau_n on (0, infinity).
///
/// Newton's method runs on psi / ||r_t||_m, which is linear in lambda for a circular cone; a bracket catches
/// the rest. The root of psi is 1 for tau_n = 0; the sign of tau_n says on which side of 1 it lies.
/// The paper's quartic, which multiplying out gives, is not used: its terms cancel for small coefficients.
double multiplier(const OrthotropicFriction &law, const Vector3d &tau)
{
  double lower = tau[0] > 0 ? 0 : 1;
  double upper = tau[0] > 0 ? 1 : std::numeric_limits<double>::infinity();
  double lambda = tau[0] > 0 ? 0 : 1;
  constexpr double settled = 4 * std::numeric_limits<double>::epsilon();
  for (unsigned int step = 0; step < most_newton_steps && tau[0] != 0; ++step)
  {
    const Vector2d r = tangential_point(law, tau, lambda);
    const double norm = friction_norm(law, r[0], r[1]);
    const double value = 1 - lambda - tau[0] / norm;
    (value > 0 ? lower : upper) = lambda;
    const double slope = -1 + tau[0] * norm_slope(law, r, norm, lambda) / (norm * norm);
    const double change = value / slope;
    // This comes before the bracket, one end of which is the root by now.
    if (slope < 0 && std::abs(change) <= settled * lambda)
      return lambda - change;
    const double next = lambda - change;
    const bool is_inside = slope < 0 && next > lower && next < upper;
    const double moved = is_inside ? next : std::isinf(upper) ? 2 * lower + 1 : 0.5 * (lower + upper);
    const bool has_settled = std::abs(moved - lambda) <= settled * moved;
    lambda = moved;
    if (has_settled)
      break;
  }
  return lambda;
}

Vector3d surface_point(const OrthotropicFriction &law, const Vector3d &tau, const double lambda)
{
  const Vector2d r = tangential_point(law, tau, lambda);
  return {friction_norm(law, r[0], r[1]), r[0], r[1]};
}

/// The law with coefficients that can be computed with. What this takes from a projection is below the last
/// digit of its largest entry.
OrthotropicFriction moderate(const OrthotropicFriction &law)
{
  return {std::clamp(law.mu_x, least_coefficient, largest_coefficient),
          std::clamp(law.mu_y, least_coefficient, largest_coefficient), law.p_x, law.p_y};
}

/// Brings a point of the moderate cone back into that of the law, whose axes may be shorter.
Vector3d shrunk(const OrthotropicFriction &law, const OrthotropicFriction &moderate, const Vector3d &point)
{
  return {point[0], point[1] * std::min(1.0, law.mu_x / moderate.mu_x),
          point[2] * std::min(1.0, law.mu_y / moderate.mu_y)};
}

/// Where a point lies with respect to the friction cone K and its polar.
Projection::Zone zone_of(const OrthotropicFriction &law, const Vector3d &tau)
{
  if (dual_norm(law, tau[1], tau[2]) + tau[0] <= 0)
    return Projection::Zone::polar;
  const bool is_inside = !is_frictionless(law) && friction_norm(law, tau[1], tau[2]) <= tau[0];
  return is_inside ? Projection::Zone::inside : Projection::Zone::outside;
}
} // namespace

bool is_frictionless(const OrthotropicFriction &law)
{
  return law.mu_x == 0;
}

Vector2d slip_weights(const OrthotropicFriction &law)
{
  if (is_frictionless(law))
    return Vector2d::Zero();
  const double x = law.p_x / law.mu_x;
  const double y = law.p_y / law.mu_y;
  return {x * x, y * y};
}

OrthotropicFriction normalized(const OrthotropicFriction &law)
{
  if (is_frictionless(law))
    return law;
  const double scale = std::max(law.p_x / law.mu_x, law.p_y / law.mu_y);
  return {law.mu_x, law.mu_y, law.p_x / scale, law.p_y / scale};
}

double friction_norm(const OrthotropicFriction &law, const double r_x, const double r_y)
{
  if (is_frictionless(law))
    return r_x == 0 && r_y == 0 ? 0 : std::numeric_limits<double>::infinity();
  return length(r_x / law.mu_x, r_y / law.mu_y);
}

double dual_norm(const OrthotropicFriction &law, const double v_x, const double v_y)
{
  return length(law.mu_x * v_x, law.mu_y * v_y);
}

Vector3d project(const OrthotropicFriction &law, const Vector3d &tau)
{
  if (const double unit = unit_of(tau); unit != 1)
    return unit * project(law, Vector3d(tau / unit)); // a cone has no scale
  if (const Projection::Zone zone = zone_of(law, tau); zone != Projection::Zone::outside)
    return zone == Projection::Zone::inside ? tau : Vector3d::Zero();
  if (is_frictionless(law))
    return {tau[0], 0, 0};
  const OrthotropicFriction used = moderate(law);
  return shrunk(law, used, surface_point(used, tau, multiplier(used, tau)));
}

Projection project_with_derivative(const OrthotropicFriction &law, const Vector3d &tau)
{
  if (const double unit = unit_of(tau); unit != 1)
  {
    Projection scaled = project_with_derivative(law, Vector3d(tau / unit));
    scaled.point *= unit;
    return scaled;
  }
  Projection projection;
  projection.zone = zone_of(law, tau);
  if (projection.zone == Projection::Zone::inside)
    projection.point = tau;
  if (projection.zone != Projection::Zone::outside)
    return projection;
  if (is_frictionless(law))
  {
    projection.point = {tau[0], 0, 0};
    projection.ray = Vector3d::UnitX();
    projection.side = Vector3d::UnitY();
    projection.normal = Vector3d::UnitZ();
    return projection;
  }
  const OrthotropicFriction used = moderate(law);
  const double lambda = multiplier(used, tau);
  const Vector3d r = surface_point(used, tau, lambda);
  projection.point = shrunk(law, used, r);
  const double x = 1 / (used.mu_x * used.mu_x);
  const double y = 1 / (used.mu_y * used.mu_y);
  projection.ray = r.normalized();
  projection.normal = Vector3d(-r[0], x * r[1], y * r[2]).normalized();
  projection.side = projection.normal.cross(projection.ray);
  // Second derivative of the Lagrangian along `side`: diag(1 - lambda, 1 + lambda/mu_x^2, 1 + lambda/mu_y^2).
  const Vector3d s = projection.side.cwiseAbs2();
  projection.stiffness = 1 / (1 + lambda * (x * s[1] + y * s[2] - s[0]));
  return projection;
}

Vector3d modified_displacement(const OrthotropicFriction &law, const Vector3d &d)
{
  const Vector2d weighted = slip_weights(law).cwiseProduct(d.tail<2>());
  return {d[0] + dual_norm(law, weighted[0], weighted[1]), weighted[0], weighted[1]};
}

Eigen::Matrix3d modified_displacement_derivative(const OrthotropicFriction &law, const Vector3d &d)
{
  const Vector2d weights = slip_weights(law);
  const Vector2d weighted = weights.cwiseProduct(d.tail<2>());
  const double norm = dual_norm(law, weighted[0], weighted[1]);
  Eigen::Matrix3d derivative = Vector3d(1, weights[0], weights[1]).asDiagonal();
  if (norm > 0)
    derivative.row(0).tail<2>() =
        weights.cwiseProduct(Vector2d(law.mu_x * law.mu_x * weighted[0], law.mu_y * law.mu_y * weighted[1])) /
        norm;
  return derivative;
}

Vector2d slip_direction(const OrthotropicFriction &law, const double r_x, const double r_y)
{
  return {-r_x / (law.p_x * law.p_x), -r_y / (law.p_y * law.p_y)};
}

Vector2d sliding_traction(const OrthotropicFriction &law, const double d_x, const double d_y)
{
  const Vector2d force(-law.p_x * law.p_x * d_x, -law.p_y * law.p_y * d_y);
  return force / friction_norm(law, force[0], force[1]);
}
} // namespace orthocone
