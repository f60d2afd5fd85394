// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rosette_sector.h"

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

Corner::Corner(const double first_angle, const double angle_between)
    : first(std::cos(first_angle), std::sin(first_angle)),
      second(std::cos(first_angle + angle_between), std::sin(first_angle + angle_between)),
      angle(angle_between),
      sine(std::sin(angle_between))
{
  dual << second[1], -second[0], -first[1], first[0];
  dual /= sine;
}

Vector2d Corner::coordinates(const Vector2d &v) const
{
  constexpr double rounding = 1e-15;
  const Vector2d coordinates = dual * v;
  const double y = std::max(coordinates[1], 0.);
  return {std::max(coordinates[0], rounding * y), y};
}

double RosetteSector::force_ratio(const double p) const
{
  return alpha * beta * p * (alpha + beta * p) / (beta + alpha * p);
}

// The positive root of alpha beta^2 p^2 + alpha (alpha beta - q) p - beta q = 0, without cancellation.
double RosetteSector::slip_ratio(const double q) const
{
  const double square = alpha * beta * beta, linear = alpha * (alpha * beta - q), constant = beta * q;
  const double root = std::sqrt(linear * linear + 4 * square * constant);
  return linear > 0 ? 2 * constant / (linear + root) : (root - linear) / (2 * square);
}

double RosetteSector::ratio_slope(const double p) const
{
  const double below = beta + alpha * p;
  return alpha * beta * beta * (alpha + 2 * beta * p + alpha * p * p) / (below * below);
}

double RosetteSector::relative_curvature(const double p) const
{
  return 2 * (beta + alpha * p) / (alpha + 2 * beta * p + alpha * p * p) - 2 * alpha / (beta + alpha * p);
}

namespace
{
struct CrossTerm
{
  double value;    ///< m
  Vector2d slopes; ///< by x and y
};

/// m = (m_0 x^2 + (m_0 + m_1 + t sqrt(g_0 g_1)) x y + m_1 y^2)/(x^2 + (2 + t) x y + y^2), t the tension.
CrossTerm cross_term(const RosetteSector &sector, const Vector2d &at)
{
  const double x = at[0], y = at[1], between = 2 + sector.tension;
  const double mixed = sector.m_0 + sector.m_1 + sector.tension * std::sqrt(sector.g_0 * sector.g_1);
  const double below = x * x + between * x * y + y * y;
  const double value = (sector.m_0 * x * x + mixed * x * y + sector.m_1 * y * y) / below;
  const Vector2d above_slopes(2 * sector.m_0 * x + mixed * y, mixed * x + 2 * sector.m_1 * y),
      below_slopes(2 * x + between * y, between * x + 2 * y);
  return {value, (above_slopes - value * below_slopes) / below};
}
} // namespace

double RosetteSector::square_of_gauge(const Vector2d &coordinates) const
{
  const double x = coordinates[0], y = coordinates[1];
  return g_0 * x * x + 2 * cross_term(*this, coordinates).value * x * y + g_1 * y * y;
}

Vector2d RosetteSector::half_gradient(const Vector2d &coordinates) const
{
  const double x = coordinates[0], y = coordinates[1];
  const CrossTerm m = cross_term(*this, coordinates);
  return Vector2d(g_0 * x + m.value * y, g_1 * y + m.value * x) + x * y * m.slopes;
}

// mu_along = e(b).e(a)/G, d b/da by the sines of both sectors, and kappa = (d b/da) grad G . e(a)/G^2: grad G
// is the normal of the curve that the forces draw, which turns with b.
RosetteSector::Conditions RosetteSector::conditions(const double p) const
{
  const double q = force_ratio(p);
  const Vector2d u = slips.first + p * slips.second, v = forces.first + q * forces.second;
  const Vector2d coordinates = Vector2d(1, q) / v.norm(), e = u.normalized();
  const double square = square_of_gauge(coordinates);
  const double turning = forces.sine / slips.sine * ratio_slope(p) * u.squaredNorm() / v.squaredNorm();
  const Vector2d normal = forces.dual.transpose() * half_gradient(coordinates); // G grad G
  return {v.normalized().dot(e) / std::sqrt(square), turning * normal.dot(e) / std::pow(square, 1.5),
          turning};
}
} // namespace orthocone
