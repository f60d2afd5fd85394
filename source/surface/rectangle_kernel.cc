// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Both means together are one integral of the kernel K over x and y, weighted by hats of the widths of the
// rectangles. Integrated twice in x and twice in y, K becomes a function G of the corners alone, of which a
// second difference in each direction is left,
//
//     mean of K = (G(x + a, y) - 2 G(x, y) + G(x - a, y) in x, and the same in y) / (a b)^2,
//
// after A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377, who has one integral in each direction. With A
// = asinh(y / |x|) and B = asinh(x / |y|) the functions are, up to terms whose differences vanish,
//
//     x^2 / R^3:  R^3 / 6 + x y^2 B / 2 - y^2 R / 2,      y^2 / R^3:  the same with x and y exchanged,
//     x y / R^3:  -x y R / 3 - (x^3 A + y^3 B) / 6,
//     x / R^2:    (x y^2 - x^3 / 3) log R / 2 + y^3 atan(x / y) / 6 + x^2 y atan(y / x) / 2,
//
// and 1 / R is the sum of the first two. The differences lose digits with the fourth power of the distance.
// Far away a Gauss rule for the hat takes their place, whose error falls with the tenth power.
#include "rectangle_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orthocone
{
namespace
{
double squared(const double x)
{
  return x * x;
}

/// x asinh(y / |x|), which vanishes at x = 0.
double times_asinh(const double x, const double y)
{
  return x == 0 ? 0 : x * std::asinh(y / std::abs(x));
}

double of_xx(const double x, const double y)
{
  const double r = std::hypot(x, y);
  return r * r * r / 6 + x * y * times_asinh(y, x) / 2 - y * y * r / 2;
}

double of_xy(const double x, const double y)
{
  return -x * y * std::hypot(x, y) / 3 - (x * x * times_asinh(x, y) + y * y * times_asinh(y, x)) / 6;
}

double of_x(const double x, const double y)
{
  const double r = std::hypot(x, y);
  const double logarithm = r > 0 ? std::log(r) : 0;
  const double of_y = y == 0 ? 0 : y * y * y * std::atan(x / y) / 6;
  const double of_both = x == 0 ? 0 : x * x * y * std::atan(y / x) / 2;
  return (x * y * y - x * x * x / 3) * logarithm / 2 + of_y + of_both;
}

/// The second differences of a function in both directions, over (a b)^2.
template<typename Function>
double differences(const Function &function, const double a, const double b, const double x, const double y)
{
  const auto in_y = [&](const double at)
  { return function(at, y + b) - 2 * function(at, y) + function(at, y - b); };
  return (in_y(x + a) - 2 * in_y(x) + in_y(x - a)) / squared(a * b);
}

/// A Gauss rule of five points for the hat 1 - |s| on -1 < s < 1, whose even moments are 1, 1/6, 1/15, 1/28,
/// 1/45: its inner points are the roots of the polynomial s^5 + p s^3 + q s that is orthogonal to s and s^3.
struct HatRule
{
  HatRule()
  {
    constexpr double m2 = 1. / 6, m4 = 1. / 15, m6 = 1. / 28, m8 = 1. / 45;
    const double determinant = m4 * m4 - m2 * m6;
    const double p = (m2 * m8 - m4 * m6) / determinant, q = (m6 * m6 - m4 * m8) / determinant;
    const double root = std::sqrt(p * p - 4 * q);
    const double near = (-p - root) / 2, far = (-p + root) / 2; // squares of the points
    const double of_far = (m4 - near * m2) / (2 * far * (far - near));
    const double of_near = (m2 - 2 * of_far * far) / (2 * near);
    points = {-std::sqrt(far), -std::sqrt(near), 0, std::sqrt(near), std::sqrt(far)};
    weights = {of_far, of_near, 1 - 2 * of_far - 2 * of_near, of_near, of_far};
  }

  std::array<double, 5> points{}, weights{};
};
} // namespace

HalfSpaceKernel mean_over_rectangles(const double width, const double height, const double distance_x,
                                     const double distance_y)
{
  constexpr double far = 12; // longer edges
  static const HatRule rule;
  HalfSpaceKernel kernel;
  if (std::hypot(distance_x, distance_y) > far * std::max(width, height))
  {
    for (std::size_t i = 0; i < rule.points.size(); ++i)
      for (std::size_t j = 0; j < rule.points.size(); ++j)
        kernel.add_point(distance_x + width * rule.points[i], distance_y + height * rule.points[j],
                         rule.weights[i] * rule.weights[j]);
    return kernel;
  }
  const auto exchanged = [](const auto &function)
  { return [&function](const double x, const double y) { return function(y, x); }; };
  const auto of = [&](const auto &function)
  { return differences(function, width, height, distance_x, distance_y); };
  kernel.xx = of(of_xx);
  kernel.yy = of(exchanged(of_xx));
  kernel.xy = of(of_xy);
  kernel.x = of(of_x);
  kernel.y = of(exchanged(of_x));
  kernel.one = kernel.xx + kernel.yy;
  return kernel;
}
} // namespace orthocone
