// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "entries/parsed.h"
#include "scene/parameter_files.h"

#include <orthocone/base/text.h>
#include <orthocone/scene/legs.h>

#include <gtest/gtest.h>

#include <regex>

#include <map>
#include <sstream>

namespace orthocone::test
{
namespace
{
std::string text_of(const Parameters &parameters)
{
  std::ostringstream text;
  write_parameters(parameters, text);
  return text.str();
}

Parameters unusual_parameters()
{
  Parameters parameters;
  parameters.geometry = {7.25, 1e-3, TopFace::guided};
  parameters.mesh = {ModelKind::quarter,     6,  5, 3, 3, 5, VolumetricQuadrature::projected, 0.37, 0.4, 1.5,
                     MeshResolution::coarse, 2.5};
  parameters.mesh.refined_cells = {{{0, 0}, {4, 7}}, {{12, 12}}};
  parameters.material = {1. / 3, -0.25};
  parameters.friction = {{{0.1, 1e-3}}, std::array<double, 2>{{2, 3}}, -12.5};
  parameters.load = {{move_to(0, 0, -0.01, 2)}, {move_to(1e-3, -2, -0.1, 3), move_to(0, 0, 0, 4)}, 7};
  parameters.contact_solver = {"gauss-seidel", 1e-7, 17, 1.2, 0.7};
  parameters.checks = {1e-7, 2, 3, 4.5, 6, 1e-9, 0.25};
  parameters.output = {3, 4, 5, 12.5, {Probe{"P", {{1, -2}}}, Probe{"rim-1", {{0, 3}}}}};
  parameters.output.line_interval = 2;
  parameters.output.lines = {{"axis", {{0, 0, 0}}, {{0, 0, 1e-3}}, 2},
                             {"L-1", {{-1, 2, 0.5}}, {{1, 2, 0.5}}, 99}};
  return parameters;
}
} // namespace

TEST(Parameters, SurviveBeingWrittenAndReadAgain)
{
  const Folder folder;
  for (const Parameters &parameters : {Parameters(), unusual_parameters()})
  {
    const std::string text = text_of(parameters);
    EXPECT_EQ(text_of(read_parameters(folder.write("all.prm", text))), text);
  }
}

TEST(Parameters, LaterEntriesAndOverridesWin)
{
  const Folder folder;
  folder.write("part/base.prm", "subsection Geometry\n  set Radius = 4\n  set Height = 5\nend\n"
                                "subsection Load program\n  set Legs = 0 0 -1 : 1\nend\n");
  folder.write("part/middle.prm", "include base.prm\nsubsection Geometry\n  set Height = 6\nend\n");
  const std::string file =
      folder.write("top.prm", "# comment\ninclude part/middle.prm # relative to this file\n");
  const Parameters parameters =
      read_parameters(file, {"Geometry/Radius=8", "Friction/Coefficients = 0.5, 0.6"});
  EXPECT_EQ(parameters.geometry.radius, 8);
  EXPECT_EQ(parameters.geometry.height, 6);
  EXPECT_EQ(parameters.friction.mu, (std::array<double, 2>{{0.5, 0.6}}));
}

TEST(Text, ReadsLegs)
{
  const auto legs = parsed(legs_codec(), " 0 0 -0.1 : 5 ; 1e-3 -2 .5:10 ;");
  ASSERT_TRUE(legs.has_value());
  ASSERT_EQ(legs->size(), 2u);
  EXPECT_EQ((*legs)[1], move_to(1e-3, -2, 0.5, 10));
  EXPECT_TRUE(parsed(legs_codec(), "")->empty());
  for (const char *const wrong :
       {"0 0 -0.1", "0 0 : 5", "0 0 0 0 : 5", "0 0 x : 5", "0 0 0 : 0", "0 0 0 : -1", "0 0 0 : 1.5",
        "0 0 0 : 5 : 6", ";", "0 0 nan : 1", "0 0 1e999 : 1"})
    EXPECT_FALSE(parsed(legs_codec(), wrong).has_value()) << wrong;
}

TEST(Text, ReadsProbes)
{
  const auto probes = parsed(probes_codec(), "P: 1 -2; rim_2: 0 0");
  ASSERT_TRUE(probes.has_value());
  EXPECT_EQ((*probes)[0].name, "P");
  EXPECT_EQ((*probes)[1].position, (std::array<double, 2>{{0, 0}}));
  EXPECT_TRUE(parsed(probes_codec(), std::string(100, 'P') + ": 1 2").has_value());
  EXPECT_FALSE(parsed(probes_codec(), std::string(101, 'P') + ": 1 2").has_value());
  for (const char *const wrong : {"P", "P: 1", "P: 1 2 3", "a/b: 1 2", ": 1 2", "P: 1 2; P: 3 4", "P: 1 inf"})
    EXPECT_FALSE(parsed(probes_codec(), wrong).has_value()) << wrong;
}

TEST(Text, ReadsLines)
{
  const auto lines = parsed(lines_codec(), " flank: 0 0 -1 to\t4 0 -1, 41 ; axis:0 0 0 to 0 0 1e-3,2");
  ASSERT_TRUE(lines.has_value());
  ASSERT_EQ(lines->size(), 2u);
  EXPECT_EQ((*lines)[0].name, "flank");
  EXPECT_EQ((*lines)[0].n_points, 41u);
  EXPECT_EQ((*lines)[0].length(), 4);
  EXPECT_EQ((*lines)[0].point(10), (std::array<double, 3>{{1, 0, -1}}));
  EXPECT_EQ((*lines)[1].point(1), (std::array<double, 3>{{0, 0, 1e-3}}));
  EXPECT_TRUE(parsed(lines_codec(), "")->empty());
  EXPECT_TRUE(parsed(lines_codec(), "a: 0 0 0 to 0 0 1, 50000; b: 0 0 0 to 0 0 1, 50000").has_value());
  for (const char *const wrong :
       {"a: 0 0 0 to 0 0 1", "a: 0 0 0 to 0 0 1, 1", "a: 0 0 0 to 0 0 0, 5", "a: 0 0 to 0 1, 5",
        "0 0 0 to 0 0 1, 5", "a: 0 0 0 0 0 1, 5", "a: 0 0 0 to 0 0 1 to 0 0 2, 5", "a: 0 0 0 to 0 0 nan, 5",
        "a: 0 0 0 to 0 0 1, 100001", "a: 0 0 0 to 0 0 1, 5; a: 0 0 0 to 0 0 2, 5", "a/b: 0 0 0 to 0 0 1, 5",
        "a: 0 0 0 to 0 0 1, 5.5", "a: 0 0 0 to 0 0 1, 5, 5", "a: to 0 0 1, 5",
        "a: -1e300 0 0 to 1e300 0 0, 5 6", "a: 0 0 0 to 0 0 1, 50001; b: 0 0 0 to 0 0 1, 50000"})
    EXPECT_FALSE(parsed(lines_codec(), wrong).has_value()) << wrong;
}

TEST(Text, FindsTheNameThatIsUsedTwiceAmongManyProbes)
{
  std::string text;
  for (unsigned int i = 0; i < 60000; ++i)
    text += "P" + std::to_string(i) + ": 0 0;";
  ASSERT_TRUE(parsed(probes_codec(), text).has_value());
  EXPECT_EQ(parsed(probes_codec(), text)->size(), 60000u);
  EXPECT_FALSE(parsed(probes_codec(), text + "P0: 0 0").has_value());
}

TEST(Text, WritesNumbersThatReadBackTheSame)
{
  for (const double value : {0.1, 1. / 3, -1e-300, 12345678.9, 5e-324})
    EXPECT_EQ(*parse_number(to_text(value)), value);
  EXPECT_EQ(to_text(0.1), "0.1");
}

TEST(Parameters, EntryValuesAreThoseOfTheFile)
{
  const auto entries = entry_values(unusual_parameters());
  const std::map<std::string, std::string> values(entries.begin(), entries.end());
  EXPECT_EQ(values.size(), entries.size()) << "an entry is listed twice";
  EXPECT_EQ(values.at("Geometry/Radius"), "7.25");
  EXPECT_EQ(values.at("Contact solver/Method"), "gauss-seidel");
  EXPECT_EQ(values.at("Load program/Legs"), "0.001 -2 -0.1 : 3; 0 0 0 : 4");
  const std::string text = text_of(unusual_parameters());
  std::size_t n_set = 0;
  for (auto place = text.find("  set "); place != std::string::npos; place = text.find("  set ", place + 1))
    ++n_set;
  EXPECT_EQ(entries.size(), n_set);
}

TEST(Parameters, AreWrittenWithTheirHelpInLinesOf78Characters)
{
  const std::string text = text_of(Parameters());
  EXPECT_EQ(text.find("# Listing of Parameters\n# ---------------------\nsubsection Geometry\n  # "), 0u);
  EXPECT_NE(
      text.find(
          "\n  # Height of a cylinder in mm. Allowed: a number > 0.\n  set Height            = 10\n\n  # "),
      std::string::npos);
  EXPECT_NE(text.find("\nend\n\n\nsubsection Mesh\n  # "), std::string::npos);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.empty() || line[2] != '#' || line.size() <= 78) << line;
}

// What shows numbers to people asks the entry for their unit.
TEST(Parameters, EntriesThatSayAUnitHaveIt)
{
  const DeclaredParameters declared;
  const std::regex says_a_unit("[^x] (in mm|in MPa|1/MPa|in degrees|in seconds|in percent)[ .;,:]");
  unsigned int n = 0;
  for (const Entry &entry : declared.list.entries())
    if (std::regex_search(entry.help(), says_a_unit) && !entry.is_path() &&
        entry.own_name() != "Regions") // both are no numbers
    {
      ++n;
      EXPECT_NE(entry.unit(), "") << entry.name() << ": " << entry.help();
    }
  EXPECT_GE(n, 15u);
  EXPECT_EQ(declared.list.find("Lower material/Young modulus")->unit(), "MPa");
  EXPECT_EQ(declared.list.find("Mesh/Degree")->unit(), "");
}
} // namespace orthocone::test
