// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/expected_contact.h>

#include <orthocone/base/numbers.h>
#include <orthocone/scene/parameters.h>

#include "scene/parameter_files.h"

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
constexpr double modulus = 210000 / (1 - 0.3 * 0.3);
} // namespace

TEST(ExpectedContact, OfASphereIsThatOfHertz)
{
  const auto contact = expected_contact(parameters_with(
      {"Obstacle/Gap=((x-1)^2+y^2)/(2*100)", "Load program/Preload=Fz -250 : 1", "Load program/Legs="}));
  ASSERT_TRUE(contact);
  const double a = std::cbrt(3 * 250 * 100 / (4 * modulus));
  EXPECT_NEAR(contact->half_widths[0], a, 1e-6 * a);
  EXPECT_NEAR(contact->half_widths[1], a, 1e-6 * a);
  EXPECT_NEAR(contact->pressure, 3 * 250 / (2 * pi * a * a), 1e-5 * contact->pressure);
  EXPECT_NEAR(contact->centre[0], 1, 1e-6);
  EXPECT_FALSE(contact->is_line());
  EXPECT_TRUE(contact->contains({1 + 0.99 * a, 0}));
  EXPECT_FALSE(contact->contains({1, 1.01 * a}));
}

// K. L. Johnson, Contact Mechanics, 1985, table of section 4.2: for R_2/R_1 = 10 the axes differ 4.68-fold
// (10^(2/3) = 4.64).
TEST(ExpectedContact, OfAnEllipsoidIsLongWhereTheGapIsFlat)
{
  const auto contact = expected_contact(parameters_with(
      {"Obstacle/Gap=x^2/(2*200)+y^2/(2*20)", "Load program/Preload=Fz -100 : 1", "Load program/Legs="}));
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->radii[0], 20, 1e-6);
  EXPECT_NEAR(contact->radii[1], 200, 1e-4);
  EXPECT_NEAR(std::abs(contact->first_axis[1]), 1, 1e-6);
  EXPECT_NEAR(contact->half_widths[1] / contact->half_widths[0], 4.68, 0.06);
}

TEST(ExpectedContact, OfARollerIsALine)
{
  const auto contact = expected_contact(
      parameters_with({"Geometry/Shape=box", "Geometry/Kind=plane strain", "Geometry/Sizes=20, 5, 10",
                       "Obstacle/Gap=x^2/(2*50)", "Load program/Preload=Fz -500 : 1", "Load program/Legs="}));
  ASSERT_TRUE(contact);
  const double b = std::sqrt(4 * 100 * 50 / (pi * modulus)); // 500 N on 5 mm
  EXPECT_TRUE(contact->is_line());
  EXPECT_NEAR(contact->half_widths[0], b, 1e-6 * b);
  EXPECT_NEAR(contact->pressure, 2 * 100 / (pi * b), 1e-5 * contact->pressure);
}

TEST(ExpectedContact, OfAMotionHasTheForceOfItsApproach)
{
  // A body so low that all of the motion is the contact's: delta = a^2/R.
  const auto contact =
      expected_contact(parameters_with({"Geometry/Height=1e-4", "Obstacle/Gap=(x^2+y^2)/(2*100)+0.002",
                                        "Load program/Preload=0 0 -0.003 : 1", "Load program/Legs="}));
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->half_widths[0], std::sqrt(100 * 0.001), 1e-3);
}

TEST(ExpectedContact, IsNotClaimedWhereNothingTellsIt)
{
  EXPECT_FALSE(expected_contact(parameters_with({})));                             // flat
  EXPECT_FALSE(expected_contact(parameters_with({"Obstacle/Gap=-x^2/200"})));      // an edge touches
  EXPECT_FALSE(expected_contact(parameters_with({"Obstacle/Gap=(x^2+y^2)/2e9"}))); // all of the base touches
}
} // namespace orthocone::test
