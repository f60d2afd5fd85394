// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/zone_record.h>

#include <gtest/gtest.h>

#include <limits>

namespace orthocone::test
{
namespace
{
constexpr double all = std::numeric_limits<double>::infinity();

struct Step
{
  double force;
  double contact;
  double stick;
};

std::string zone_warning_of(const std::vector<Step> &steps, const Parameters &parameters = {})
{
  ZoneRecord record;
  unsigned int number = 0;
  for (const Step &step : steps)
    record.add_step(++number, step.force, {step.contact, step.stick, all, step.contact == all});
  const auto warnings = zone_warnings(parameters, record);
  EXPECT_LE(warnings.size(), 1u);
  return warnings.empty() ? "" : warnings.front();
}
} // namespace

TEST(Zones, ThatAreNarrowAreWarnedOf)
{
  EXPECT_NE(zone_warning_of({{1, 1, 1}}).find("the contact is one node spacing wide"), std::string::npos);
  EXPECT_NE(zone_warning_of({{1, 1, 0}, {2, 3, 1}}).find("3 node spacings"), std::string::npos);
  EXPECT_EQ(zone_warning_of({{1, 1, 1}, {2, 5, 5}}), ""); // it grows from a point
  const std::string stick = zone_warning_of({{1, 9, 9}, {1, 9, 5}, {1, 9, 3}, {1, 9, 9}, {1, 9, 5}});
  EXPECT_NE(stick.find("load step 3: the stick zone is 3 node spacings wide"), std::string::npos) << stick;
  EXPECT_NE(zone_warning_of({{1, 9, 9}, {1, 9, 1}}).find("load step 2: the stick zone"), std::string::npos);
  ZoneRecord point;
  point.add_step(1, 1, {9, 9, 2, false});
  ASSERT_EQ(zone_warnings({}, point).size(), 1u);
  EXPECT_NE(zone_warnings({}, point).front().find("carries the load"), std::string::npos);
}

TEST(Zones, ThatVanishAreNot)
{
  EXPECT_EQ(zone_warning_of({}), "");
  EXPECT_EQ(zone_warning_of({{0, 0, 0}}), "");                                          // no contact
  EXPECT_EQ(zone_warning_of({{1, all, 7}, {0.5, 3, 1}, {0, 0, 0}}), "");                // unloading
  EXPECT_EQ(zone_warning_of({{1, all, 7}, {1, all, 3}, {1, all, 0}, {1, all, 9}}), ""); // gross sliding
  EXPECT_EQ(zone_warning_of({{1, all, 7}, {0.5, 9, 1}, {1, all, 7}}), ""); // a turn under less load
  EXPECT_EQ(zone_warning_of({{1, all, 1}, {2, all, 1}}), "");              // friction never held it
}

TEST(Zones, NameTheEntriesOfTheirShape)
{
  Parameters parameters;
  const auto names = [&](const std::string &entry) {
    return zone_warning_of({{1, 1, 1}}, parameters).find(entry) != std::string::npos;
  };
  EXPECT_TRUE(names("Mesh/Resolution = custom") && names("Core cells") && names("Core ratio"));
  parameters.geometry.shape = BodyShape::box;
  EXPECT_TRUE(names("Mesh/Cells"));
  parameters.geometry.shape = BodyShape::file;
  EXPECT_TRUE(names("Geometry/Mesh file"));
}

// A mesh that is too coarse for slip at the rim is none where the rim is open.
TEST(Rim, IsWarnedOfWhereItTouches)
{
  Parameters parameters;
  parameters.mesh.degree = 1;
  parameters.mesh.layers = 1;
  parameters.obstacle.gap = "x^2/100";
  for (const bool touches : {false, true})
  {
    ZoneRecord record;
    record.add_step(1, 1, {9, 9, all, touches});
    EXPECT_EQ(zone_warnings(parameters, record).size(), touches ? 1u : 0u);
  }
}
} // namespace orthocone::test
