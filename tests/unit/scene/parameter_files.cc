// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// How parameter files are read, and the sentences with which they are rejected; many more are in
// tests/errors.
#include "scene/parameter_files.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
const std::string form = "{\"Section\": {\"Entry\": value}}";
const std::string list = "'orthocone --defaults' lists all of them";
} // namespace

TEST(Readers, TakeTabsLineEndsAndMarksAsTheyCome)
{
  const Folder folder;
  for (const std::string end : {"\n", "\r\n", "\r"})
    for (const std::string mark : {"", "\xef\xbb\xbf"})
    {
      const std::string text = mark + "subsection\tMesh # of the body" + end + "\tset\tLayers\t=\t7" + end +
                               "end # Mesh" + end + "subsection Geometry" + end + "set Radius = 3" + end +
                               "end";
      const Parameters parameters = read_parameters(folder.write("x.prm", text));
      EXPECT_EQ(parameters.mesh.layers, 7u);
      EXPECT_EQ(parameters.geometry.radius, 3);
    }
  EXPECT_EQ(read_parameters(folder.write("x.JSON", "\xef\xbb\xbf{\"Mesh\": {\"Layers\": 7}}")).mesh.layers,
            7u);
}

TEST(Readers, JoinContinuedLinesWithABlank)
{
  const Folder folder;
  const std::string file =
      folder.write("x.prm", "subsection Load program\n  set Legs = 0 0 \\\n  -1\\\n : 5; \\ \n"
                            "  0 0 0 : 1 # back\n  set Cycles = 3\nend\n");
  const LoadOptions load = read_parameters(file).load;
  ASSERT_EQ(load.legs.size(), 2u);
  EXPECT_EQ(load.legs[0], move_to(0, 0, -1, 5));
  EXPECT_EQ(load.cycles, 3u);
  EXPECT_NE(rejection(folder.write("y.prm", "subsection Load program\n  set Legs = 0 0 -1\\\n0 : 5\nend\n")),
            "");
}

TEST(Readers, DoNotLetACommentSwallowTheNextLine)
{
  const Folder folder;
  const std::string file = folder.write("x.prm", "subsection Mesh\n  # C:\\\n  set Degree = 9\nend\n");
  EXPECT_EQ(rejection(file),
            file + ":2: '# C:\\' ends in a backslash, which would make a comment of the next line as well");
}

TEST(Readers, NameFileAndLineOfAFaultInAnIncludedFile)
{
  const Folder folder;
  const std::string part =
      folder.write("part/base.prm", "subsection Geometry\n\n  set Radius = -4 # mm\nend\n");
  const std::string file = folder.write("top.prm", "include part/base.prm\n");
  EXPECT_EQ(rejection(file), part + ":3: Geometry/Radius = -4: allowed is a number > 0");
}

TEST(Readers, FindCirclesOfIncludesButAllowAFileTwice)
{
  const Folder folder;
  folder.write("part/radius.prm", "subsection Geometry\n  set Radius = 2\nend\n");
  folder.write("part/again.prm", "include ../part/radius.prm\n");
  const std::string twice = folder.write("twice.prm", "include part/radius.prm\ninclude part/again.prm\n");
  EXPECT_EQ(read_parameters(twice).geometry.radius, 2);

  const std::string circle = folder.write("circle.prm", "include part/back.prm\n");
  const std::string back = folder.write("part/back.prm", "include ../part/../circle.prm\n");
  EXPECT_EQ(rejection(circle), back + ":1: " + circle + ": is included by itself");
  std::filesystem::create_symlink(circle, folder.path("part/link.prm"));
  folder.write("part/back.prm", "include link.prm\n");
  EXPECT_EQ(rejection(circle), back + ":1: " + folder.path("part/link.prm") + ": is included by itself");
}

TEST(Readers, TellOfAFaultInALongValueWithoutRepeatingAllOfIt)
{
  const Folder folder;
  std::string legs;
  for (unsigned int i = 0; i < 5000; ++i)
    legs += "0 0 -0.1 : 5 ; ";
  const std::string file =
      folder.write("long.prm", "subsection Load program\n  set Legs = " + legs + "0 0 : 1\nend\n");
  const std::string message = rejection(file);
  EXPECT_NE(message, "") << "a leg of two coordinates was accepted";
  EXPECT_LT(message.size(), 600u);
}

TEST(Readers, CutAndEscapeWhatTheyQuote)
{
  const Folder folder;
  const std::string file = folder.write("good.prm", "subsection Mesh\n  set Degree = 1\nend\n");
  const std::string allowed = ": allowed is auto | full | half | quarter | axisymmetric";
  const std::string remark = " (with characters beyond ASCII)";
  EXPECT_EQ(rejection(file, {"Mesh/Model=a\n\t\x1b\x7f"}), "--set: Mesh/Model = a\\n\\t\\x1b\\x7f" + allowed);
  std::string letters; // of two bytes each, but for the first
  for (unsigned int i = 0; i < 150; ++i)
    letters += "\xc3\xbc";
  EXPECT_EQ(rejection(file, {"Mesh/Model=" + letters}),
            "--set: Mesh/Model = " + letters.substr(0, 200) + "..." + remark + allowed);
  EXPECT_EQ(rejection(file, {"Mesh/Model=x" + letters}),
            "--set: Mesh/Model = x" + letters.substr(0, 198) + "..." + remark + allowed);
}

TEST(Readers, AreNotFooledByAValueThatQuotesTheLibrary)
{
  const Folder folder;
  const std::string value = "<x> does not match the given pattern <y>.";
  const std::string message =
      "Mesh/Model = " + value + ": allowed is auto | full | half | quarter | axisymmetric";
  const std::string json = folder.write("x.json", "{\"Mesh\": {\"Model\": \"" + value + "\"}}");
  EXPECT_EQ(rejection(json), json + ": " + message);
  const std::string prm = folder.write("x.prm", "subsection Mesh\n  set Model = " + value + "\nend\n");
  EXPECT_EQ(rejection(prm), prm + ":2: " + message);
}

TEST(Readers, RejectJsonOfAnotherForm)
{
  const Folder folder;
  const std::vector<std::pair<std::string, std::string>> texts{
      {std::string(200000, '['), ": is nested more than 10 deep; allowed is " + form},
      {"{\"Mesh\": {\"Degree\": " + std::string(9, '[') + std::string(9, ']') + "}}",
       ": is nested more than 10 deep; allowed is " + form},
      {"{\"Mesh\": {\"Degree\": 9, \"Degree\": 2}}", ": Mesh/Degree is given twice"},
      {"{\"Mesh\": {}, \"Mesh\": {\"Degree\": 2}}", ": Mesh is given twice"},
      {"{\n\n\"\xc3\xbc\": }", ":3: is not valid JSON at column 6; allowed is " + form},
      {"{\"Mesh\": {}}", ": sets no entry; 'orthocone --defaults' prints a complete parameter file"},
      {"{\"Msh\": {}}", ": Msh is not a section; is Mesh meant? " + list},
      {"{\"Mesh\": 2}", ": Mesh = 2: allowed is the form {\"Mesh\": {\"Entry\": value}}"},
      {"{\"Degree\": 2}", ": Degree is not a section; is Mesh/Degree meant? " + list}};
  for (const auto &[text, message] : texts)
  {
    const std::string file = folder.write("x.json", text);
    EXPECT_EQ(rejection(file), file + message);
  }
}

TEST(Readers, SuggestTheNameThatIsMostLikelyMeant)
{
  const Folder folder;
  const std::string file = folder.write("good.prm", "subsection Mesh\n  set Degree = 1\nend\n");
  const std::vector<std::pair<std::string, std::string>> meant{
      {"Mesh/Degre", "Mesh/Degree"},
      {"mesh/degree", "Mesh/Degree"},
      {"Msh/Degree", "Mesh/Degree"},
      {"Degree", "Mesh/Degree"},
      {"Mesh/Radius", "Geometry/Radius"},
      {"Friction/Coeficients", "Friction/Coefficients"},
      {"Load program/Cylces", "Load program/Cycles"},
      {"Load program/Number of cycles", "Load program/Cycles"},
      {"Friction/Angle", "Friction/Orthotropy angle"},
      {"Friction/mu", "Friction/Coefficients"},
      {"mu_x", "Friction/Coefficients"},
      {"Material/E", "Material/Young modulus"},
      {"nu", "Material/Poisson ratio"},
      {"Load program/Force", "Load program/Legs"},
      {"Geometry/Diameter", "Geometry/Radius"},
      {"Mesh/Order", "Mesh/Degree"},
      {"Contact solver/Solver", "Contact solver/Method"},
      {"Angle", "Friction/Orthotropy angle"}};
  for (const auto &[name, nearest] : meant)
  {
    const std::string message = rejection(file, {name + "=1"});
    EXPECT_NE(message.find("is " + nearest + " meant?"), std::string::npos) << name << ": " << message;
  }
}

TEST(Readers, SuggestNothingForANameThatIsLikeNoOther)
{
  const Folder folder;
  const std::string file = folder.write("good.prm", "subsection Mesh\n  set Degree = 1\nend\n");
  for (const std::string name : {"Foo/Bar", "Output/Folder", "Solver options/Verbose", "Mesh/"})
    EXPECT_EQ(rejection(file, {name + "=1"}), "--set: " + name + " is not an entry; " + list);
}

TEST(Readers, ShowANameThatIsEmpty)
{
  const Folder folder;
  const std::string file = folder.write("x.json", "{\"\": {\"Degree\": 2}}");
  EXPECT_EQ(rejection(file), file + ": '' is not a section; " + list);
}

TEST(Readers, TakeASectionWithASlashForAnEntry)
{
  const Folder folder;
  const std::string file = folder.write("x.prm", "subsection Mesh/Degree\n  set Degree = 2\nend\n");
  EXPECT_EQ(rejection(file), file + ":1: Mesh/Degree is not a section; is Mesh/Degree meant? " + list);
}
} // namespace orthocone::test
