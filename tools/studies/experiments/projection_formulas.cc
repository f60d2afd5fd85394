// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "projection_formulas.h"

#include "contact/law/quartic.h"

#include <orthocone/base/numbers.h>

#include <map>
#include <stdexcept>

namespace orthocone::studies
{
namespace
{
using Complex = std::complex<double>;
using Eigen::Vector3d;
constexpr unsigned int most_steps = 200;

/// Functions of the multiplier whose root is sought, with their slopes, in the precision Real.
template<typename Real>
struct Secular
{
  Secular(const OrthotropicFriction &law, const Vector3d &tau)
      : x(Real(law.mu_x) * Real(law.mu_x)),
        y(Real(law.mu_y) * Real(law.mu_y)),
        n(Real(tau[0])),
        t_x(Real(tau[1]) / Real(law.mu_x)),
        t_y(Real(tau[2]) / Real(law.mu_y))
  {
  }

  /// ||r_t(lambda)||_m and its derivative.
  void norm_at(const Real lambda, Real &norm, Real &slope) const
  {
    const Real a = t_x / (1 + lambda / x);
    const Real b = t_y / (1 + lambda / y);
    norm = std::sqrt(a * a + b * b);
    slope = -(a * a / (x + lambda) + b * b / (y + lambda)) / norm;
  }

  /// psi = ||r_t|| (1 - lambda) - tau_n.
  void psi(const Real lambda, Real &value, Real &slope) const
  {
    Real norm, norm_slope;
    norm_at(lambda, norm, norm_slope);
    value = norm * (1 - lambda) - n;
    slope = norm_slope * (1 - lambda) - norm;
  }

  /// psi / ||r_t||.
  void relative(const Real lambda, Real &value, Real &slope) const
  {
    Real norm, norm_slope;
    norm_at(lambda, norm, norm_slope);
    value = 1 - lambda - n / norm;
    slope = -1 + n * norm_slope / (norm * norm);
  }

  Real x, y, n, t_x, t_y;
};

template<typename Real>
using Function = void (Secular<Real>::*)(Real, Real &, Real &) const;

Vector3d point_at(const OrthotropicFriction &law, const Vector3d &tau, const double lambda)
{
  const double x = tau[1] / (1 + lambda / (law.mu_x * law.mu_x));
  const double y = tau[2] / (1 + lambda / (law.mu_y * law.mu_y));
  return {friction_norm(law, x, y), x, y};
}

/// Newton's method from the left, without any safeguard.
template<Function<double> function>
double plain_newton(const OrthotropicFriction &law, const Vector3d &tau)
{
  const Secular<double> equation(law, tau);
  double lambda = tau[0] > 0 ? 0 : 1;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    double value, slope;
    (equation.*function)(lambda, value, slope);
    const double change = value / slope;
    lambda -= change;
    if (std::abs(change) <= 4 * std::numeric_limits<double>::epsilon() * std::abs(lambda))
      return lambda > 0 ? lambda : std::numeric_limits<double>::quiet_NaN();
  }
  return std::numeric_limits<double>::quiet_NaN();
}

enum class Variant
{
  settles_first,  ///< a step that is rounding ends the search, before one that leaves the bracket is replaced
  halves_at_root, ///< the other way round: at the root, an end of the bracket by then, the rest of it is
                  ///< halved
  halves,         ///< halving alone
};

/// Newton's method in a bracket.
template<typename Real, Function<Real> function, Variant variant = Variant::settles_first>
double bracketed(const OrthotropicFriction &law, const Vector3d &tau)
{
  const Secular<Real> equation(law, tau);
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  Real lower = tau[0] > 0 ? 0 : 1;
  Real upper = tau[0] > 0 ? 1 : infinity;
  Real lambda = tau[0] > 0 ? 0 : 1;
  for (unsigned int step = 0; step < most_steps && tau[0] != 0; ++step)
  {
    Real value, slope;
    (equation.*function)(lambda, value, slope);
    (value > 0 ? lower : upper) = lambda;
    Real next = lambda - value / slope;
    if (variant == Variant::settles_first &&
        std::abs(value / slope) <= 4 * std::numeric_limits<Real>::epsilon() * lambda)
      return double(next);
    if (variant == Variant::halves || !(slope < 0 && next > lower && next < upper))
      next = std::isinf(upper) ? 2 * lower + 1 : (lower + upper) / 2;
    const bool has_settled = std::abs(next - lambda) <= 4 * std::numeric_limits<Real>::epsilon() * next;
    lambda = next;
    if (has_settled)
      break;
  }
  return double(lambda);
}

double companion(const OrthotropicFriction &law, const Vector3d &tau)
{
  return test::wanted_root(law, tau, test::companion_roots(test::multiplier_quartic(law, tau)));
}

/// The largest root of z^3 + a z^2 + b z + c by Cardano's formula: Ferrari's formula divides by it.
Complex cubic_root(const Complex &a, const Complex &b, const Complex &c)
{
  const Complex p = b - a * a / 3.;
  const Complex q = 2. * a * a * a / 27. - a * b / 3. + c;
  const Complex root = std::sqrt(q * q / 4. + p * p * p / 27.);
  const Complex sum = std::abs(-q / 2. + root) > std::abs(-q / 2. - root) ? -q / 2. + root : -q / 2. - root;
  const Complex u = std::pow(sum, 1. / 3.);
  Complex largest = -a / 3.;
  for (int k = 0; k < 3 && u != 0.; ++k)
  {
    const Complex v = u * std::polar(1., 2 * pi * k / 3);
    const Complex root_k = v - p / (3. * v) - a / 3.;
    if (std::abs(root_k) > std::abs(largest))
      largest = root_k;
  }
  return largest;
}

/// Ferrari's closed form.
double ferrari(const OrthotropicFriction &law, const Vector3d &tau)
{
  const test::Quartic k = test::multiplier_quartic(law, tau);
  const double b = k[3] / k[4], c = k[2] / k[4], d = k[1] / k[4], e = k[0] / k[4];
  // z^4 + p z^2 + q z + r with lambda = z - b/4.
  const double p = c - 3 * b * b / 8;
  const double q = d - b * c / 2 + b * b * b / 8;
  const double r = e - b * d / 4 + b * b * c / 16 - 3 * b * b * b * b / 256;
  const Complex m = cubic_root(p, p * p / 4 - r, -q * q / 8); // its resolvent
  const Complex s = std::sqrt(2. * m);
  test::QuarticRoots roots;
  for (unsigned int i = 0; i < 4; ++i)
  {
    const double first = i < 2 ? 1 : -1, second = i % 2 == 0 ? 1 : -1;
    const Complex other = std::sqrt(-(2 * p + 2. * m + (s == 0. ? 0. : first * 2 * q / s)));
    roots[i] = 0.5 * (first * s + second * other) - b / 4;
  }
  return test::wanted_root(law, tau, roots);
}

/// The projection by a formula for the multiplier.
template<double (*multiplier)(const OrthotropicFriction &, const Vector3d &)>
Vector3d with(const OrthotropicFriction &law, const Vector3d &tau)
{
  if (dual_norm(law, tau[1], tau[2]) + tau[0] <= 0)
    return Vector3d::Zero(); // in the polar cone
  if (friction_norm(law, tau[1], tau[2]) <= tau[0])
    return tau;
  return point_at(law, tau, multiplier(law, tau));
}

/// Closed form for mu_x = mu_y; of other laws it takes the geometric mean.
Vector3d circular(const OrthotropicFriction &law, const Vector3d &tau)
{
  const double mu = std::sqrt(law.mu_x * law.mu_y);
  const double t = std::hypot(tau[1], tau[2]);
  if (mu * t + tau[0] <= 0)
    return Vector3d::Zero();
  if (t <= mu * tau[0])
    return tau;
  const double r_n = (tau[0] + mu * t) / (1 + mu * mu);
  return {r_n, mu * r_n * tau[1] / t, mu * r_n * tau[2] / t};
}
} // namespace

Formula projection_formula(const std::string &name)
{
  using Single = Secular<float>;
  using Double = Secular<double>;
  static const std::map<std::string, Formula> formulas{
      {"program", project},
      {"newton-halves-at-root", with<bracketed<double, &Double::relative, Variant::halves_at_root>>},
      {"newton-relative-single", with<bracketed<float, &Single::relative>>},
      {"newton-psi", with<bracketed<double, &Double::psi>>},
      {"plain-newton-psi", with<plain_newton<&Double::psi>>},
      {"plain-newton-relative", with<plain_newton<&Double::relative>>},
      {"bisection", with<bracketed<double, &Double::psi, Variant::halves>>},
      {"companion", with<companion>},
      {"ferrari", with<ferrari>},
      {"circular", circular},
  };
  const auto found = formulas.find(name);
  if (found == formulas.end())
    throw std::runtime_error("there is no formula '" + name + "'");
  return found->second;
}
} // namespace orthocone::studies
