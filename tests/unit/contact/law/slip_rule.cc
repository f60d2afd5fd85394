// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact/laws.h"

#include <orthocone/base/numbers.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{
Vector2d unit(const double angle)
{
  return {std::cos(angle), std::sin(angle)};
}

constexpr double degree = pi / 180;
} // namespace

// Numbers of steady slip at 45 degrees for mu = (0.8, 0.4), worked out by hand from the slip rules.
TEST(SlipRule, GivesTheKnownTractionsAt45Degrees)
{
  const Vector2d d = unit(45 * degree);
  const Vector2d associated = sliding_traction({0.8, 0.4, 0.8, 0.4}, d[0], d[1]);
  EXPECT_NEAR(associated.norm(), 0.73756, 5e-6);
  EXPECT_NEAR(std::atan2(-associated[1], -associated[0]) / degree, 14.04, 5e-3);
  const Vector2d collinear = sliding_traction({0.8, 0.4, 1, 1}, d[0], d[1]);
  EXPECT_NEAR(collinear.norm(), 0.50596, 5e-6);
  EXPECT_NEAR(std::atan2(-collinear[1], -collinear[0]) / degree, 45, 1e-12);
}

TEST(SlipRule, TractionLiesOnTheEllipseAndSlipFollowsFromIt)
{
  for (const OrthotropicFriction &law : {case_a, case_b, case_c})
    for (double angle = 0; angle < 360; angle += 7.5)
    {
      const Vector2d d = unit(angle * degree);
      const Vector2d t = sliding_traction(law, d[0], d[1]);
      EXPECT_NEAR(friction_norm(law, t[0], t[1]), 1, 1e-14);
      EXPECT_LT(t.dot(d), 0);
      const Vector2d slip = slip_direction(law, t[0], t[1]);
      EXPECT_NEAR(slip[0] * d[1] - slip[1] * d[0], 0, 1e-13 * slip.norm());
      EXPECT_GT(slip.dot(d), 0);
    }
}

// The variational inequality of the law: the natural map vanishes for slipping, stuck and open nodes, and
// only there.
TEST(NaturalMap, VanishesExactlyWhereTheLawHolds)
{
  constexpr double normal_force = 3;
  for (const OrthotropicFriction &law : {case_a, case_b, case_c})
    for (double angle = 0; angle < 360; angle += 7.5)
      for (const double rho : {0.01, 1., 100.})
      {
        const Vector2d d = unit(angle * degree);
        const Vector2d t = normal_force * sliding_traction(law, d[0], d[1]);
        const auto map = [&](const Vector3d &r, const Vector3d &displacement)
        { return (r - project(law, r - rho * modified_displacement(law, displacement))).norm(); };
        const Vector3d slipping(normal_force, t[0], t[1]);
        const double seen = 0.05 * std::min(rho, 1.); // a violation moves the map by about rho times its size
        EXPECT_LE(map(slipping, {0, d[0], d[1]}), 1e-12); // slip
        EXPECT_GT(map(slipping, {0, -d[0], -d[1]}),
                  seen * slip_weights(law).minCoeff());    // slip along the force
        EXPECT_GT(map(slipping, {0.1, d[0], d[1]}), seen); // force over a gap
        EXPECT_LE(map({normal_force, 0.5 * t[0], 0.5 * t[1]}, Vector3d::Zero()), 1e-15); // stick
        EXPECT_GT(map({normal_force, 0.5 * t[0], 0.5 * t[1]}, {0, 0.1 * d[0], 0.1 * d[1]}),
                  0.1 * seen * slip_weights(law).minCoeff());       // slip inside
        EXPECT_LE(map(Vector3d::Zero(), {0.2, d[0], d[1]}), 1e-15); // open
        EXPECT_GT(map(Vector3d::Zero(), {-0.2, 0, 0}), seen);       // penetration
      }
}

TEST(NaturalMap, DoesNotDependOnTheLengthOfTheSlipEllipseWhenNormalized)
{
  const OrthotropicFriction law = normalized(case_c);
  const OrthotropicFriction longer = normalized({case_c.mu_x, case_c.mu_y, 7 * case_c.p_x, 7 * case_c.p_y});
  EXPECT_NEAR(law.p_x, longer.p_x, 1e-16);
  EXPECT_NEAR(law.p_y, longer.p_y, 1e-16);
  EXPECT_NEAR(slip_weights(law).maxCoeff(), 1, 1e-15);
  EXPECT_NEAR(law.p_x / law.p_y, case_c.p_x / case_c.p_y, 1e-15);
}

TEST(ModifiedDisplacement, HasTheDerivativeOfDifferences)
{
  constexpr double step = 1e-6;
  for (const OrthotropicFriction &law : {case_a, case_b, case_c})
    for (const Vector3d &d : directions())
    {
      if (d.tail<2>().norm() < 1e-3)
        continue; // the norm has a kink
      Eigen::Matrix3d differences;
      for (int i = 0; i < 3; ++i)
        differences.col(i) = (modified_displacement(law, d + step * Vector3d::Unit(i)) -
                              modified_displacement(law, d - step * Vector3d::Unit(i))) /
                             (2 * step);
      EXPECT_LE((modified_displacement_derivative(law, d) - differences).norm(), 1e-8);
    }
}
} // namespace orthocone::test
