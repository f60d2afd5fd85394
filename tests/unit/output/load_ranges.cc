// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/load_ranges.h>

#include <orthocone/output/model_text.h>
#include <orthocone/scene/parameters.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
Parameters with(const std::vector<std::pair<std::string, std::string>> &load,
                const std::vector<std::pair<std::string, std::string>> &geometry = {})
{
  return with_section(with_section(Parameters(), "Geometry", geometry), "Load program", load);
}

std::string drive_of(const std::vector<std::pair<std::string, std::string>> &load)
{
  return describe_drive(with(load).load);
}
} // namespace

TEST(LoadRanges, HaveTheLargestValueOfEachComponent)
{
  EXPECT_EQ(drive_of({{"Load program/Preload", "Fz -900 Fx 0 : 2"},
                      {"Load program/Legs", "Fx 350 : 6 ; Fx -350 : 12 ; Fx 350 : 12"}}),
            "driven by      Fx -350 to 350 N, Fz -900 N\n");
  EXPECT_EQ(drive_of({{"Load program/Legs", "0 0 -0.1 : 5 ; 0 0 0 : 10"}}), "driven by      uz -0.1 mm\n");
  EXPECT_EQ(drive_of({{"Load program/Legs", "uz -0.1 : 1 ; rz 0.5 : 2 ; Mz 10 Fy 0 : 1"}}),
            "driven by      uz -0.1 mm, rz 0.5 degrees, Fy 0 N, Mz 10 N mm\n");
}

TEST(LoadRanges, NameLoadsWithTheirUnits)
{
  EXPECT_EQ(drive_of({{"Load program/Loads", "bulk: traction on side along x ; warm: temperature"},
                      {"Load program/Legs", "uz -0.1 bulk 100 : 1 ; bulk -50 warm 20 : 2"}}),
            "driven by      uz -0.1 mm\n"
            "loads          bulk: traction on side along x, -50 to 100 MPa\n"
            "               warm: temperature, 20 K\n");
}

TEST(LoadRanges, AreBesideWhatHoldsTheBody)
{
  const Parameters parameters =
      with({}, {{"Geometry/Supports", "side: x y"}, {"Geometry/Top face", "guided"}});
  EXPECT_EQ(describe_held(parameters),
            "held face      top, guided: moved along z, free sideways\nsupports       side: x y\n");
  EXPECT_EQ(describe_materials(parameters), "material       E 210000 MPa, nu 0.3\n");
  EXPECT_EQ(describe_held(with({}, {{"Geometry/Top face", "free"}})),
            "held face      none: supports, loads and contact hold the body\n");
}
} // namespace orthocone::test
