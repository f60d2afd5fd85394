// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Loops whose figures have closed forms.
#include <orthocone/results/fretting_loop.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
using Eigen::Vector2d;

namespace
{
constexpr double mu = 0.6, pressed = 50;

/// A spring (N/mm) in front of a block that slides: force of a way (mm) that turns at +-`amplitude`.
double parallelogram(const double way, const double sense, const double amplitude, const double stiffness)
{
  const double limit = mu * pressed;
  return sense * std::min(limit, stiffness * (amplitude + sense * way) - limit);
}

/// From one end of the stroke to the other and back, in `direction`, around `centre`.
std::vector<LoopPoint> gross_slip(const double amplitude, const double stiffness, const Vector2d &direction,
                                  const Vector2d &centre, const int n)
{
  std::vector<LoopPoint> points;
  const auto add = [&](const double way, const double sense)
  {
    const double tangential = parallelogram(way, sense, amplitude, stiffness);
    points.push_back({centre + way * direction, tangential * direction, pressed, -0.1});
  };
  add(amplitude, 1);
  for (const double sense : {-1., 1.})
    for (int i = 1; i <= n; ++i)
      add(sense * (2. * i / n - 1) * amplitude, sense);
  return points;
}

/// Cattaneo and Mindlin: motion of a sphere, relative to that at which all slips, under q = Q/(mu P).
double shift(const double q)
{
  return 1 - std::pow(1 - q, 2. / 3);
}
} // namespace

// In whatever direction and place: the program need not move along an axis or around zero.
TEST(FrettingLoop, GrossSlipIsAParallelogram)
{
  constexpr double amplitude = 0.05, stiffness = 2000;
  const double half_width = amplitude - mu * pressed / stiffness;
  for (const double angle : {0., 0.5, 1.5707963267948966, 2.5})
  {
    const Vector2d direction(std::cos(angle), std::sin(angle));
    const LoopFigures loop = loop_figures(gross_slip(amplitude, stiffness, direction, {0.3, -0.2}, 100));
    EXPECT_NEAR(loop.stroke, 2 * amplitude, 1e-15);
    EXPECT_NEAR(loop.peak_force, mu * pressed, 1e-12);
    EXPECT_NEAR(loop.slip_ratio.value(), half_width / amplitude, 1e-12);
    EXPECT_NEAR(loop.energy_ratio.value(), half_width / amplitude, 1e-12);
    EXPECT_NEAR(loop.friction_largest.value(), mu, 1e-12);
    EXPECT_NEAR(loop.friction_energy.value(), mu, 1e-12);
    EXPECT_NEAR(loop.friction_geometric.value(), mu, 1e-12);
    EXPECT_NEAR(loop.stiffness.value() / stiffness, 1, 1e-9);
  }
}

// Driven by a force: partial slip between +-q of the limit, which Masing's rule makes of the first loading.
// The coefficients stay below that of friction, each as far as the loop is from a parallelogram.
TEST(FrettingLoop, PartialSlipHasItsClosedForm)
{
  constexpr double q = 0.6, limit = mu * pressed;
  constexpr int n = 400;
  std::vector<LoopPoint> points;
  for (const double sense : {1., -1.})
    for (int i = sense > 0 ? 0 : 1; i <= n; ++i)
    {
      const double fallen = 2. * q * i / n; // since the reversal
      points.push_back(
          {{sense * (shift(q) - 2 * shift(fallen / 2)), 0}, {sense * (q - fallen) * limit, 0}, pressed, -1});
    }
  // Johnson, Contact mechanics, equation (7.58).
  const double dissipation =
      4.8 * limit * (1 - std::pow(1 - q, 5. / 3) - 5 * q / 6 * (1 + std::pow(1 - q, 2. / 3)));
  const double ratio = 1 - 2 * shift(q / 2) / shift(q);
  const LoopFigures loop = loop_figures(points);
  EXPECT_NEAR(loop.stroke, 2 * shift(q), 1e-12);
  EXPECT_NEAR(loop.slip_ratio.value(), ratio, 1e-12);
  EXPECT_NEAR(loop.energy_ratio.value(), dissipation / (4 * q * limit * shift(q)), 1e-5);
  EXPECT_LT(loop.energy_ratio.value(), 0.2); // partial slip, by Fouvry's criterion
  EXPECT_NEAR(loop.friction_largest.value(), q * mu, 1e-12);
  EXPECT_NEAR(loop.friction_energy.value(), dissipation / (4 * pressed * ratio * shift(q)), 1e-4);
  EXPECT_LT(loop.friction_energy.value(), mu);
  const double at_middle = 2 * (1 - std::pow(1 - shift(q) / 2, 1.5)) - q; // force over the limit
  EXPECT_NEAR(loop.friction_geometric.value(), at_middle * mu, 1e-5);
  const double first = 2 * q / n;
  EXPECT_NEAR(loop.stiffness.value(), first * limit / (2 * shift(first / 2)), 1e-9);
}

// What sticks closes its loop; what only presses has none, also where a tolerance moves the face aside.
TEST(FrettingLoop, WhatALoopDoesNotHaveIsNothing)
{
  std::vector<LoopPoint> stuck, press;
  for (const double way : {0.01, 0., -0.01, 0., 0.01})
  {
    stuck.push_back({{way, 0}, {1000 * way, 0}, pressed, -0.1});
    press.push_back({{1e-10 * way, 0}, {1e-9, 0}, pressed, -0.1 + way});
  }
  const LoopFigures closed = loop_figures(stuck), none = loop_figures(press);
  EXPECT_EQ(closed.slip_ratio.value(), 0);
  EXPECT_NEAR(closed.energy_ratio.value(), 0, 1e-15);
  EXPECT_NEAR(closed.friction_largest.value(), 0.2, 1e-12);
  EXPECT_NEAR(closed.friction_geometric.value(), 0, 1e-12);
  EXPECT_NEAR(closed.stiffness.value(), 1000, 1e-9);
  EXPECT_FALSE(closed.friction_energy);
  EXPECT_EQ(none.stroke, 0);
  EXPECT_FALSE(none.slip_ratio || none.energy_ratio || none.friction_largest || none.friction_geometric ||
               none.stiffness);
  EXPECT_EQ(loop_figures({}).stroke, 0);
}

// The first cycle begins in the middle, and loads what has never slipped: its loop is the one behind that.
TEST(FrettingLoop, TheFirstCycleIsReadBehindItsFirstLoading)
{
  constexpr double amplitude = 0.05, stiffness = 2000;
  const std::vector<LoopPoint> whole = gross_slip(amplitude, stiffness, {1, 0}, {0, 0}, 50);
  std::vector<LoopPoint> points{{{0, 0}, {0, 0}, pressed, -0.1},
                                {{0.4 * amplitude, 0}, {30, 0}, pressed, -0.1}};
  points.insert(points.end(), whole.begin(), whole.end());
  const double half_width = amplitude - mu * pressed / stiffness;
  const LoopFigures loop = loop_figures(points);
  EXPECT_NEAR(loop.slip_ratio.value(), half_width / amplitude, 1e-12);
  EXPECT_NEAR(loop.energy_ratio.value(), half_width / amplitude, 1e-12);
  EXPECT_NEAR(loop.friction_energy.value(), mu, 1e-12);
  EXPECT_NEAR(loop.friction_geometric.value(), mu, 1e-12);
  EXPECT_NEAR(loop.stiffness.value(), stiffness, 1e-6);
}
} // namespace orthocone::test
