// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
// Entries that may be expressions.
#include "scene/parameter_files.h"

#include <gtest/gtest.h>

#include <map>

namespace orthocone::test
{
namespace
{
/// Parameters with one entry set.
Parameters with(const std::string &setting)
{
  const Folder folder;
  return read_parameters(folder.write("good.prm", "subsection Mesh\n  set Degree = 1\nend\n"), {setting});
}

std::string printed(const Parameters &parameters, const std::string &entry)
{
  const auto values = entry_values(parameters);
  return std::map<std::string, std::string>(values.begin(), values.end()).at(entry);
}

std::string fault_of_setting(const std::string &setting)
{
  const Folder folder;
  return rejection(folder.write("good.prm", "subsection Mesh\n  set Degree = 1\nend\n"), {setting});
}
} // namespace

TEST(FieldEntries, TakeExpressionsOfThePlace)
{
  const FrictionOptions friction = with("Friction/Coefficients = 0.3+0.1*x, max(0.1,min(y,0.2))").friction;
  EXPECT_TRUE(friction.varies());
  EXPECT_EQ(friction.at(1, 0.15).mu, (std::array<double, 2>{{0.4, 0.15}}));
  EXPECT_EQ(friction.mu, (std::array<double, 2>{{0.3, 0.1}})) << "at the centre";
  EXPECT_FALSE(friction.at(1, 0).varies());
  EXPECT_TRUE(friction.is_associated());
  const FrictionOptions slip = with("Friction/Slip potential = 1, 1+x^2").friction;
  EXPECT_EQ(slip.at(2, 0).p(), (std::array<double, 2>{{1, 5}}));
  EXPECT_FALSE(slip.is_associated() || slip.is_collinear()) << "although p_x = p_y at the centre";
  EXPECT_DOUBLE_EQ(with("Friction/Orthotropy angle = atan2(y,x)*180/pi").friction.at(-1, 0).angle, 180);
}

TEST(FieldEntries, AreNumbersWhereTheyDoNotVary)
{
  const FrictionOptions friction = with("Friction/Coefficients = 3/10, 0.15").friction;
  EXPECT_FALSE(friction.varies());
  EXPECT_DOUBLE_EQ(friction.mu[0], 0.3);
  EXPECT_DOUBLE_EQ(with("Friction/Orthotropy angle = 90/2").friction.angle, 45);
  EXPECT_TRUE(with("Friction/Coefficients = 0, 0").friction.is_frictionless());
}

TEST(FieldEntries, KnowCollinearSlipByItsWord)
{
  const Parameters parameters = with("Friction/Slip potential = collinear");
  EXPECT_TRUE(parameters.friction.is_collinear());
  EXPECT_FALSE(parameters.friction.is_associated());
  EXPECT_EQ(parameters.friction.p(), (std::array<double, 2>{{1, 1}}));
  EXPECT_EQ(printed(parameters, "Friction/Slip potential"), "collinear");
  FrictionOptions varying = with("Friction/Coefficients = 1+x^2, 2").friction;
  varying.is_collinear_by_word = true;
  EXPECT_TRUE(varying.is_collinear() && varying.at(1, 1).is_collinear());
}

TEST(FieldEntries, ArePrintedAsGiven)
{
  for (const std::string setting :
       {"Friction/Coefficients=0.3+0.1*x, max(0.1,y)", "Friction/Slip potential=1+x, 2",
        "Friction/Orthotropy angle=atan2(y,x)*180/pi", "Obstacle/Gap=(x^2+y^2)/(2*1000)"})
  {
    const auto equals = setting.find('=');
    EXPECT_EQ(printed(with(setting), setting.substr(0, equals)), setting.substr(equals + 1));
  }
}

TEST(FieldEntries, ReplaceEachOther)
{
  const Folder folder;
  const std::string file = folder.write("a.prm", "subsection Friction\n  set Coefficients = 1+x, 1+y\n"
                                                 "  set Slip potential = 2+x, 1\n"
                                                 "  set Orthotropy angle = x\nend\n");
  const FrictionOptions friction =
      read_parameters(file, {"Friction/Coefficients=0.1, 0.2", "Friction/Slip potential=collinear",
                             "Friction/Slip potential=associated", "Friction/Orthotropy angle=3"})
          .friction;
  EXPECT_FALSE(friction.varies() || friction.is_collinear());
  EXPECT_TRUE(friction.is_associated());
  EXPECT_EQ(friction.angle, 3);
}

TEST(FieldEntries, TellWhatIsWrongInAnExpression)
{
  const std::string pair = ": allowed is two numbers > 0 (or both 0: no friction) separated by a comma, or "
                           "expressions of x, y and z";
  EXPECT_EQ(fault_of_setting("Friction/Coefficients=0.1, foo(x)"),
            "--set: Friction/Coefficients = 0.1, foo(x)" + pair + "; in 'foo(x)' 'foo' is not known");
  EXPECT_EQ(fault_of_setting("Friction/Coefficients=atan2(x,y)"),
            "--set: Friction/Coefficients = atan2(x,y)" + pair);
  EXPECT_EQ(fault_of_setting("Friction/Coefficients=0, 1+x^2"),
            "--set: Friction/Coefficients = 0, 1+x^2" + pair);
  EXPECT_EQ(
      fault_of_setting("Obstacle/Gap=x^"),
      "--set: Obstacle/Gap = x^: allowed is a number, or an expression of x, y and z; it ends too early");
  EXPECT_EQ(fault_of_setting("Obstacle/Gap=1/0"),
            "--set: Obstacle/Gap = 1/0: allowed is a number, or an expression of x, y and z");
  EXPECT_EQ(
      fault_of_setting("Friction/Orthotropy angle=500-1"),
      "--set: Friction/Orthotropy angle = 500-1: allowed is a number >= -360 and <= 360, or an expression "
      "of x, y and z");
}

TEST(FieldEntries, TellTheLimitThatAPairIsBeyond)
{
  EXPECT_EQ(
      fault_of_setting("Friction/Slip potential=1, 1e301"),
      "--set: Friction/Slip potential = 1, 1e301: allowed is associated, or two numbers > 0 and < 1e+300 "
      "separated by a comma, or collinear, or expressions of x, y and z");
  EXPECT_NE(
      fault_of_setting("Friction/Coefficients=1e300, 1").find("two numbers > 0 and < 1e+300 (or both 0"),
      std::string::npos);
}

TEST(FieldEntries, FindTheGapFileFromTheFileThatNamesIt)
{
  const Folder folder;
  folder.write("part/gap.prm", "subsection Obstacle\n  set Gap file = grid.txt\nend\n");
  const std::string file = folder.write("top.prm", "include part/gap.prm\n");
  EXPECT_EQ(read_parameters(file).obstacle.gap_file, folder.path("part/grid.txt"));
  EXPECT_EQ(read_parameters(file, {"Obstacle/Gap file="}).obstacle.gap_file, "");
  EXPECT_FALSE(read_parameters(file).obstacle.is_plane());
  const std::string json = folder.write("part/x.json", "{\"Obstacle\": {\"Gap file\": \"../grid.txt\"}}");
  EXPECT_EQ(read_parameters(json).obstacle.gap_file, folder.path("grid.txt"));
}

TEST(FieldEntries, KnowThePlane)
{
  EXPECT_TRUE(with("Obstacle/Gap = 0.0").obstacle.is_plane());
  EXPECT_TRUE(with("Obstacle/Gap = 2-2").obstacle.is_plane());
  EXPECT_FALSE(with("Obstacle/Gap = 0.1").obstacle.is_plane());
  EXPECT_FALSE(with("Obstacle/Gap = 0*x").obstacle.is_plane());
}
} // namespace orthocone::test
