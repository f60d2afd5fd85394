// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rejection.h"

#include <orthocone/scene/model_choice.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
Parameters with_gap(const char *gap)
{
  Parameters parameters;
  parameters.friction.mu = {{0.3, 0.3}};
  parameters.mesh.core_cells = 2;
  parameters.obstacle.gap = gap;
  return parameters;
}

Parameters with_angle(const char *angle)
{
  Parameters parameters = with_gap("0");
  parameters.friction.mu = {{0.4, 0.2}};
  parameters.friction.varying_angle = Expression(angle);
  return parameters;
}

std::string model(const Parameters &parameters)
{
  return choose_model(parameters).symmetry.name();
}

std::string symmetry_rejection(const Parameters &parameters)
{
  return rejection_of([&] { choose_model(parameters); });
}

Drive force(const double value)
{
  return {true, value};
}
} // namespace

TEST(Asymmetry, IsThatOfTheGap)
{
  const ModelChoice sphere = choose_model(with_gap("(x^2+y^2)/200"));
  EXPECT_EQ(sphere.symmetry.name(), "axisymmetric");
  EXPECT_EQ(sphere.reason,
            "friction and gap are the same all around and the held face moves along the axis; gap and "
            "friction were compared at all contact nodes");
  EXPECT_EQ(model(with_gap("x^2/200")), "quarter");
  EXPECT_EQ(model(with_gap("(x^2+y^2)/200*(1+0.1*cos(17*atan2(y,x)))")), "half")
      << "17 waves around: no mirror x";
  EXPECT_EQ(model(with_gap("x/200+0.05")), "half");
  EXPECT_EQ(choose_model(with_gap("x*y/1000+1")).symmetry.name(), "full");
  EXPECT_NE(choose_model(with_gap("x/200+0.05")).reason.find("Obstacle/Gap is "), std::string::npos);
}

TEST(Asymmetry, IsThatOfFriction)
{
  EXPECT_EQ(model(with_angle("atan2(y,x)*180/pi")), "axisymmetric");
  EXPECT_EQ(model(with_angle("90+atan2(y,x)*180/pi")), "axisymmetric");
  const ModelChoice spirals = choose_model(with_angle("20+atan2(y,x)*180/pi")); // they have no mirror
  EXPECT_EQ(spirals.symmetry.full_name(), "axisymmetric with twist");
  EXPECT_NE(spirals.reason.find("with the twist, because friction at ("), std::string::npos)
      << spirals.reason;
  EXPECT_EQ(model(with_angle("x*y")), "quarter");
  EXPECT_EQ(model(with_angle("x")), "half");
  Parameters stripes = with_gap("0");
  stripes.friction.varying_mu =
      std::array<Expression, 2>{{Expression("0.3+0.1*cos(x)"), Expression("0.3+0.1*cos(x)")}};
  EXPECT_EQ(model(stripes), "quarter");
  Parameters shaft = with_angle("x");
  shaft.mesh.model = ModelKind::quarter;
  EXPECT_NE(symmetry_rejection(shaft).find("Mesh/Model = quarter is not possible: friction at ("),
            std::string::npos);
  EXPECT_NE(symmetry_rejection(shaft).find("possible models are full, half"), std::string::npos);
}

TEST(Asymmetry, NeedsGapAndFrictionEverywhere)
{
  EXPECT_NE(
      symmetry_rejection(with_gap("sqrt(81-x^2)")).find("Obstacle/Gap = sqrt(81-x^2) is not a number at ("),
      std::string::npos);
  Parameters parameters = with_gap("0");
  parameters.friction.varying_mu = std::array<Expression, 2>{{Expression("0.3-x/20"), Expression("0.3")}};
  EXPECT_NE(symmetry_rejection(parameters).find("Friction/Coefficients = 0.3-x/20, 0.3 is -"),
            std::string::npos);
}

// Without contact a force has nothing to press on.
TEST(FirstContact, IsMadeByAMotion)
{
  Parameters parameters = with_gap("0.01+(x^2+y^2)/200");
  Leg press;
  press.targets[2] = force(-100);
  parameters.load.legs = {press};
  EXPECT_EQ(symmetry_rejection(parameters),
            "Load program/Legs: Fz presses from leg 1 on, where a gap of 0.01 mm is open: "
            "allowed is a leg before it that closes the gap by a motion of uz");
  parameters.load.preload = {move_to(0, 0, -0.005, 1)};
  EXPECT_NE(symmetry_rejection(parameters).find("a gap of 0.005 mm is open"), std::string::npos);
  parameters.load.preload = {move_to(0, 0, -0.01, 1)};
  EXPECT_EQ(symmetry_rejection(parameters), "");
  parameters.load.preload.clear();
  Leg tilt = move_to(0, 0, 0, 1);
  tilt.targets[4] = Drive{false, 0.1}; // degrees about y: the rim comes down
  parameters.obstacle.gap = "0.01";
  parameters.load.legs = {tilt, press};
  EXPECT_EQ(symmetry_rejection(parameters), "");
  parameters.obstacle.gap = "0";
  parameters.load.legs = {move_to(0, 0, -0.01, 1), move_to(0, 0, 0.1, 1), press};
  EXPECT_NE(symmetry_rejection(parameters).find("from leg 3 on, where a gap of 0.1 mm is open"),
            std::string::npos)
      << "a plane";
  parameters.load.legs = {press, move_to(0, 0, 0.1, 1)};
  parameters.obstacle.gap = "(x^2+y^2)/200";
  EXPECT_EQ(symmetry_rejection(parameters), "") << "one cycle";
  parameters.load.cycles = 2;
  EXPECT_NE(symmetry_rejection(parameters).find("a gap of 0.1 mm is open"), std::string::npos)
      << "lifted in the first";
}
} // namespace orthocone::test
