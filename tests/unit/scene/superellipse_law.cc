// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "parameter_files.h"

#include <orthocone/base/numbers.h>
#include <orthocone/scene/options.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
using Eigen::Vector2d;

FrictionLaw superellipse(const std::vector<std::string> &more)
{
  std::vector<std::string> settings{"Friction/Law=superellipse", "Friction/Coefficients=0.3, 0.15"};
  settings.insert(settings.end(), more.begin(), more.end());
  const FrictionOptions friction = parameters_with(settings).friction;
  return friction.law.chosen().law(friction, Eigen::Vector3d::Zero());
}

/// Of the force on the cone against a direction of slip, as a vector of powers.
Vector2d powers(const Vector2d &v, const double exponent)
{
  return v.array().abs().pow(exponent) * v.array().sign();
}
} // namespace

TEST(Superellipse, IsTheEllipseForExponentTwo)
{
  const FrictionLaw law = superellipse({"Friction/Exponent=2", "Friction/Slip potential=1, 3"});
  const FrictionLaw ellipse = OrthotropicFriction{0.3, 0.15, 1, 3};
  for (unsigned int i = 0; i < 100; ++i)
  {
    const Vector2d slip(std::cos(0.1 + 2 * pi * i / 100), std::sin(0.1 + 2 * pi * i / 100));
    EXPECT_LE((law.force_against(slip) - ellipse.force_against(slip)).norm(), 1e-12);
  }
}

// Forces lie on the cone, and slip is along the normal of its own curve, up to 0.1 degrees.
TEST(Superellipse, FollowsItsFormula)
{
  const Vector2d mu(0.3, 0.15), p(1, 0.7);
  for (const double q : {1.05, 1.5, 3., 8., 20.})
    for (const double s : {1.05, 1.6, 4., 20.})
    {
      const FrictionLaw law =
          superellipse({"Friction/Exponent=" + std::to_string(q),
                        "Friction/Slip exponent=" + std::to_string(s), "Friction/Slip potential=1, 0.7"});
      for (unsigned int i = 0; i < 400; ++i)
      {
        const double a = 2 * pi * (i + 0.37) / 400;
        const Vector2d slip(std::cos(a), std::sin(a)), force = law.force_against(slip);
        const double load = std::pow(powers(force.cwiseQuotient(mu).cwiseAbs(), q).sum(), 1 / q);
        EXPECT_NEAR(load, 1, 3e-3) << q << " " << s << " " << a;
        const Vector2d normal = powers(force.cwiseQuotient(p), s - 1).cwiseQuotient(p).normalized();
        // Where slip turns fast with the force, the force is that of a direction nearby.
        const Vector2d inverse = -powers(slip.cwiseProduct(p), 1 / (s - 1)).cwiseProduct(p).normalized();
        const double by_slip = std::asin(normal[0] * -slip[1] - normal[1] * -slip[0]),
                     by_force =
                         std::asin(inverse[0] * force.normalized()[1] - inverse[1] * force.normalized()[0]);
        EXPECT_LE(std::min(std::abs(by_slip), std::abs(by_force)), 3e-3) << q << " " << s << " " << a;
      }
    }
}
} // namespace orthocone::test
