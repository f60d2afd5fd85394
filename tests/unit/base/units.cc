// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/units.h>

#include <orthocone/base/numbers.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
TEST(Units, AreConvertedToThoseOfTheProgram)
{
  EXPECT_EQ(parse_quantity("7 um", "mm"), 0.007) << "as a user writes it in mm";
  EXPECT_EQ(parse_quantity("-10um", "mm"), -0.01);
  EXPECT_EQ(parse_quantity("2.5e1 \u00b5m", "mm"), 0.025);
  EXPECT_EQ(parse_quantity("1e-3 m", "mm"), 1);
  EXPECT_EQ(parse_quantity("0.2 GPa", "MPa"), 200);
  EXPECT_EQ(parse_quantity("3 N/mm^2", "MPa"), 3);
  EXPECT_EQ(parse_quantity("2 kN", "N"), 2000);
  EXPECT_EQ(parse_quantity("2 kN m", "N mm"), 2e6);
  EXPECT_NEAR(*parse_quantity("1 rad", "degrees"), 180 / pi, 1e-12);
  EXPECT_EQ(parse_quantity("30 deg", "degrees"), 30);
  // 1 mm^3 a N m is 1 mm^3 a 1000 N mm.
  EXPECT_DOUBLE_EQ(*parse_quantity("5e-5 mm^3/(N m)", "MPa\u207b\u00b9"), 5e-8);
  EXPECT_EQ(parse_quantity("12 ppm/K", "1/K"), 1.2e-5);
  EXPECT_EQ(parse_quantity("4.5", "mm"), 4.5) << "a bare number is in the unit of the program";
}

TEST(Units, OfAnotherQuantityAreRefused)
{
  EXPECT_FALSE(parse_quantity("3 N", "mm"));
  EXPECT_FALSE(parse_quantity("3 GPA", "MPa")) << "upper and lower case differ: mN is not MN";
  EXPECT_FALSE(parse_quantity("3 um", "")) << "a pure number has none";
  EXPECT_FALSE(parse_quantity("um", "mm"));
  EXPECT_FALSE(parse_quantity("3 4", "mm"));
  EXPECT_EQ(fault_of_units("3 N", "mm").substr(0, 23), "; N is a unit of force,");
  EXPECT_NE(fault_of_units("0.5 mm", "").find("no unit"), std::string::npos);
  EXPECT_NE(fault_of_units("3 GPA", "MPa").find("GPA is none of the units"), std::string::npos);
  EXPECT_EQ(fault_of_units("x^2 + 1", "mm"), "");
  EXPECT_EQ(fault_of_units("2 x", "mm"), "") << "a part of an expression";
}

TEST(Units, OfListsAreEachTheirOwn)
{
  EXPECT_EQ(without_units("2 cm, 5, 100 um", "mm"), "20, 5, 0.1");
  EXPECT_EQ(without_units("2, 5", "mm"), "2, 5");
  EXPECT_EQ(without_units("(x^2+y^2)/200, 1 m", "mm"), "(x^2+y^2)/200, 1000");
  EXPECT_EQ(without_units("10 %", "%"), "10 %");
}
} // namespace orthocone::test
