// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "experiments.h"
#include "projection_formulas.h"

#include <orthocone/base/numbers.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <random>
#include <stdexcept>

namespace orthocone::studies
{
namespace
{
using Eigen::Vector3d;
using Digits50 = boost::multiprecision::cpp_bin_float_50;

/// The multiplier with 50 digits. The root of psi is bracketed and then halved in the logarithm, which needs
/// no thought about convergence, and polished by Newton's method.
Digits50 exact_multiplier(const OrthotropicFriction &law, const Vector3d &tau)
{
  const Digits50 x = Digits50(law.mu_x) * law.mu_x, y = Digits50(law.mu_y) * law.mu_y;
  const Digits50 a = Digits50(tau[1]) * law.mu_x, b = Digits50(tau[2]) * law.mu_y, n = tau[0];
  const auto evaluate = [&](const Digits50 &l, Digits50 &slope)
  {
    const Digits50 u = a / (x + l), v = b / (y + l), norm = sqrt(u * u + v * v);
    slope = -(u * u / (x + l) + v * v / (y + l)) / norm * (1 - l) - norm;
    return Digits50(norm * (1 - l) - n);
  };
  Digits50 lower = 1e-30, upper = 1e30, slope;
  for (int i = 0; i < 40; ++i)
  {
    const Digits50 middle = sqrt(lower * upper);
    (evaluate(middle, slope) > 0 ? lower : upper) = middle;
  }
  Digits50 lambda = sqrt(lower * upper);
  for (int i = 0; i < 6; ++i)
  {
    const Digits50 value = evaluate(lambda, slope);
    lambda -= value / slope;
  }
  return lambda;
}

/// |r - exact projection| / |tau|: projections do not expand distances, so rounding tau costs no more than
/// epsilon.
double error_of(const OrthotropicFriction &law, const Vector3d &tau, const Digits50 &lambda,
                const Vector3d &r)
{
  const Digits50 x = Digits50(tau[1]) / (1 + lambda / (Digits50(law.mu_x) * law.mu_x));
  const Digits50 y = Digits50(tau[2]) / (1 + lambda / (Digits50(law.mu_y) * law.mu_y));
  const Digits50 u = x / law.mu_x, v = y / law.mu_y;
  const Digits50 n = sqrt(u * u + v * v);
  return Vector3d(double(n - r[0]), double(x - r[1]), double(y - r[2])).norm() / tau.norm();
}

class Points
{
public:
  /// Points outside of the cone and its polar.
  std::vector<Vector3d> of_class(const std::string &name, const OrthotropicFriction &law, const std::size_t n)
  {
    std::vector<Vector3d> points;
    for (unsigned int trial = 0; points.size() < n && trial < 1000000; ++trial)
    {
      const Vector3d tau = uniform_power(1e-3, 1e3) * one(name, law).normalized();
      if (friction_norm(law, tau[1], tau[2]) > tau[0] && dual_norm(law, tau[1], tau[2]) + tau[0] > 0)
        points.push_back(tau);
    }
    if (points.size() < n)
      throw std::runtime_error("no points of class '" + name + "'");
    return points;
  }

private:
  /// The standard's engines, but not its distributions, give the same numbers everywhere.
  double uniform() { return double(engine_() >> 11) * 0x1p-53; }
  double uniform_power(const double from, const double to) { return from * std::pow(to / from, uniform()); }

  Vector3d direction()
  {
    const double height = 2 * uniform() - 1, angle = 2 * pi * uniform(),
                 radius = std::sqrt(1 - height * height);
    return {height, radius * std::cos(angle), radius * std::sin(angle)};
  }

  /// The point that projects on a point of the surface, with the given multiplier.
  Vector3d above_surface(const OrthotropicFriction &law, const double lambda)
  {
    const double angle = 2 * pi * uniform(), c = std::cos(angle), s = std::sin(angle);
    return Vector3d(1, law.mu_x * c, law.mu_y * s) + lambda * Vector3d(-1, c / law.mu_x, s / law.mu_y);
  }

  Vector3d one(const std::string &name, const OrthotropicFriction &law)
  {
    const double least = std::pow(std::min(law.mu_x, law.mu_y), 2),
                 most = std::pow(std::max(law.mu_x, law.mu_y), 2);
    Vector3d tau = direction();
    if (name == "near the cone")
      return above_surface(law, std::min(1., least) * uniform_power(1e-12, 1e-3));
    if (name == "near the polar")
      return above_surface(law, std::max(1., most) * uniform_power(1e3, 1e10));
    if (name == "an axis")
      tau[1 + int(2 * uniform())] *= uniform() < 0.5 ? 0 : uniform_power(1e-12, 1e-3);
    else if (name == "no pressure")
      tau[0] *= uniform_power(1e-12, 1e-3);
    else if (name != "generic")
      throw std::runtime_error("there is no class '" + name + "'");
    return tau;
  }

  std::mt19937_64 engine_{20060911};
};

/// Median over batches of the nanoseconds of a call.
double nanoseconds(const Formula formula, const OrthotropicFriction &law, const std::vector<Vector3d> &points)
{
  constexpr int n_batches = 7, n_rounds = 8;
  std::array<double, n_batches> times{};
  double sum = 0; // so that no call can be left out
  for (double &time : times)
  {
    const auto begin = std::chrono::steady_clock::now();
    for (int round = 0; round < n_rounds; ++round)
      for (const Vector3d &tau : points)
        sum += formula(law, tau)[0];
    const std::chrono::duration<double, std::nano> duration = std::chrono::steady_clock::now() - begin;
    time = duration.count() / double(n_rounds * points.size());
  }
  std::sort(times.begin(), times.end());
  volatile double sink = sum;
  static_cast<void>(sink);
  return times[n_batches / 2];
}

std::vector<OrthotropicFriction> laws_of(const std::string &name)
{
  std::vector<OrthotropicFriction> laws;
  const auto add = [&](const double mu, const double ratio) {
    laws.push_back({mu, mu / ratio, mu, mu / ratio});
  };
  if (name == "usual")
    for (const double mu : {0.1, 0.3, 0.9})
      for (const double ratio : {1., 1.2, 2., 4.})
        add(mu, ratio);
  else if (name == "circular")
    for (const double mu : {1e-3, 0.1, 0.3, 1., 1e3})
      add(mu, 1);
  else if (name == "wide")
    for (const double mu : {1e-3, 0.03, 1., 1e3})
      for (const double ratio : {1., 1 + 1e-9, 2., 10., 1000.})
        add(mu, ratio);
  else
    throw std::runtime_error("there are no laws '" + name + "'");
  return laws;
}

/// Prints the rest of a line: time, digits and points without an answer.
void compare(const Formula formula, const OrthotropicFriction &law, const std::vector<Vector3d> &taus)
{
  std::vector<double> digits;
  for (const Vector3d &tau : taus)
  {
    const double error = error_of(law, tau, exact_multiplier(law, tau), formula(law, tau));
    if (std::isfinite(error))
      digits.push_back(std::clamp(-std::log10(error), 0., 16.));
  }
  const std::size_t failures = taus.size() - digits.size();
  std::sort(digits.begin(), digits.end());
  std::cout << nanoseconds(formula, law, taus) << "," << (digits.empty() ? 0 : digits.front()) << ","
            << (digits.empty() ? 0 : digits[digits.size() / 2]) << "," << failures << "," << taus.size()
            << "\n";
}
} // namespace

void projection(const Words &words)
{
  if (words.size() != 2)
    throw std::runtime_error("two words: formula, laws");
  const Formula formula = projection_formula(words[0]);
  std::cout << "class,mu_x,mu_y,nanoseconds,worst_digits,median_digits,failures,points\n";
  for (const char *name : {"generic", "an axis", "no pressure", "near the cone", "near the polar"})
  {
    Points points;
    for (const OrthotropicFriction &law : laws_of(words[1]))
    {
      std::cout << name << "," << law.mu_x << "," << law.mu_y << ",";
      compare(formula, law, points.of_class(name, law, 64));
    }
  }
}
} // namespace orthocone::studies
