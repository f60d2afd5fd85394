// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rejection.h"

#include <orthocone/base/numbers.h>
#include <orthocone/scene/change_length.h>
#include <orthocone/scene/friction_field.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
std::array<Expression, 2> pair(const char *x, const char *y)
{
  return {{Expression(x), Expression(y)}};
}

/// Axes along radius and hoop.
FrictionOptions polar()
{
  FrictionOptions friction;
  friction.mu = {{0.4, 0.2}};
  friction.varying_angle = Expression("atan2(y,x)*180/pi");
  return friction;
}

std::string friction_rejection(const FrictionOptions &friction)
{
  return rejection_of([&] { FrictionField(friction).check({{{1, 2, 0}}, {{3, 4, 0}}}); });
}

ContactSurface surface_of(const std::vector<Eigen::Vector2d> &places)
{
  ContactSurface surface;
  for (const auto &place : places)
    surface.nodes.push_back({{{place[0], place[1]}}, 1, {}, {{true, true, true}}});
  return surface;
}
} // namespace

TEST(FrictionField, HasALawAtEveryPlace)
{
  FrictionOptions friction;
  friction.varying_mu = pair("0.1*x", "0.05*x");
  EXPECT_EQ(friction_rejection(friction), "");
  const auto laws = FrictionField(friction).laws(surface_of({{1, 0}, {3, 0}}), *make_obstacle({}), {});
  EXPECT_DOUBLE_EQ(laws[1].ellipse()->mu_x, 0.3);
  EXPECT_DOUBLE_EQ(laws[1].ellipse()->p_y, 0.15) << "associated: p = mu";
  friction.varying_mu = pair("1-x/2", "0.1");
  EXPECT_EQ(friction_rejection(friction),
            "Friction/Coefficients = 1-x/2, 0.1 is -0.5, 0.1 at (3, 4) mm of the contact surface: "
            "allowed are two finite numbers > 0, or both 0 (no friction)");
  friction.varying_mu = pair("if(x<2,0,0.1)", "if(x<2,0,0.2)");
  EXPECT_EQ(friction_rejection(friction), "") << "no friction at one place";
  friction.varying_slip_potential = pair("1", "sqrt(x-2)");
  friction.slip_potential = std::array<double, 2>{{1, 1}};
  EXPECT_EQ(friction_rejection(friction), "") << "p means nothing where there is no friction";
  friction.varying_mu = pair("0.1+0*x", "0.1");
  EXPECT_NE(friction_rejection(friction).find("Friction/Slip potential = 1, sqrt(x-2) is 1, "),
            std::string::npos);
  friction.varying_slip_potential = std::nullopt;
  friction.varying_angle = Expression("1/(x-3)");
  EXPECT_EQ(friction_rejection(friction),
            "Friction/Orthotropy angle = 1/(x-3) is infinite at (3, 4) mm of the contact surface: "
            "allowed is a finite number (degrees)");
}

// The ellipse of friction, as a tensor, turns with the place.
TEST(FrictionField, TurnsWithTheRadius)
{
  const FrictionField field(polar());
  for (const double angle : {0., 0.3, 2., -3.})
  {
    const Eigen::Vector2d radial(std::cos(angle), std::sin(angle));
    const auto entries = field.numbers({7 * radial[0], 7 * radial[1], 0});
    Eigen::Matrix2d friction;
    friction << entries[0], entries[1], entries[1], entries[2];
    EXPECT_NEAR((friction * radial - 0.16 * radial).norm(), 0, 1e-15);
  }
}

TEST(FrictionField, LiesAlongTheRadiusOfASection)
{
  const ContactSurface rings = surface_of({{0, 0}, {5, 0}});
  const ModelSymmetry section = ModelSymmetry::of_revolution();
  const auto plane = make_obstacle({});
  EXPECT_EQ(FrictionField(polar()).laws(rings, *plane, section)[1].ellipse()->mu_x, 0.4);
  FrictionOptions hoop = polar();
  hoop.varying_angle = Expression("90+atan2(y,x)*180/pi");
  hoop.slip_potential = std::array<double, 2>{{0.3, 0.1}};
  const OrthotropicFriction law = *FrictionField(hoop).laws(rings, *plane, section)[1].ellipse();
  EXPECT_EQ(law.mu_x, 0.2);
  EXPECT_EQ(law.mu_y, 0.4);
  EXPECT_EQ(law.p_x, 0.1);
  EXPECT_TRUE(FrictionField(hoop).axes(rings, *plane, section).is_uniform());
}

// On a cylinder about z the axis z is along the surface everywhere, and the hoop follows from it.
TEST(FrictionField, ProjectsItsFirstAxis)
{
  ObstacleOptions bore;
  bore.distance = "5 - sqrt(x^2 + y^2)";
  FrictionOptions friction;
  friction.mu = {{0.1, 0.3}};
  friction.first_axis = std::array<Expression, 3>{{Expression("0"), Expression("0"), Expression("2")}};
  const ContactSurface surface = surface_of({{5, 0}, {3, 4}, {0, -5}});
  const auto obstacle = make_obstacle(bore);
  const LocalAxes axes = FrictionField(friction).axes(surface, *obstacle, {});
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d place = surface.nodes[i].place();
    EXPECT_LE((axes.normal(i) + place / 5).norm(), 1e-12) << "into the shaft";
    EXPECT_LE((axes.to_global(i, {1, 0}) - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
    EXPECT_NEAR(axes.to_global(i, {0, 1}).dot(place), 0, 1e-11);
  }
  friction.first_axis = std::array<Expression, 3>{{Expression("x"), Expression("y"), Expression("0")}};
  EXPECT_EQ(rejection_of([&] { FrictionField(friction).axes(surface, *obstacle, {}); }),
            "Friction/First axis: the first axis of orthotropic friction is along the normal at (5, 0) mm of "
            "the contact surface: allowed is a direction that is along the surface, such as First axis = 0, "
            "0, 1 where the normal is horizontal");
  friction.mu = {{0.2, 0.2}};
  EXPECT_NO_THROW(FrictionField(friction).axes(surface, *obstacle, {})) << "any tangents will do";
}

// A sine of wave length L ranges over 2 amplitudes and is steepest with 2 pi / L amplitudes: L / pi.
TEST(ChangeLength, IsTheRangeDividedByTheSlope)
{
  const ContactSurface surface = surface_of({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 1}});
  const LocalAxes straight(0.);
  const auto lengths =
      change_lengths(*make_obstacle({"0.01*sin(2*pi*x/4)", ""}), FrictionField({}), surface, straight);
  EXPECT_NEAR(lengths[0] / (4 / pi), 1, 1e-6);
  EXPECT_GT(lengths[1], 100) << "at the crest";
  EXPECT_TRUE(std::isinf(change_lengths(*make_obstacle({"1", ""}), FrictionField({}), surface, straight)[0]));
  const auto of_polar = change_lengths(*make_obstacle({}), FrictionField(polar()), surface, straight);
  EXPECT_GT(of_polar[3], 0.1) << "the jump of atan2 is no change of friction";
  EXPECT_LT(of_polar[3], 3.1) << "it turns by a radian on the way of a radius";
}
} // namespace orthocone::test
