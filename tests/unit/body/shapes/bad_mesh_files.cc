// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "bad_meshes.h"

#include "folder_of_files.h"
#include "rejection.h"

#include <orthocone/body/shapes/imported_mesh.h>

#include <deal.II/base/exceptions.h>

#include <gtest/gtest.h>

#include <set>

namespace orthocone::test
{
namespace
{
std::string sentence(const GeometryOptions &geometry)
{
  BodyOptions body;
  body.geometry = geometry;
  return rejection_of(
      [&]
      {
        check_body(body);
        const ImportedMesh mesh(geometry);
      });
}

/// What is said of a mesh; the assertions of deal.II's reader find cells without volume before our checks do.
std::string expected(const Row &row)
{
#ifdef DEBUG
  if (row.fault == std::string("inverted") || row.fault == std::string("collapsed"))
    return "its elements do not fit together";
#endif
  return row.expected;
}

void expect_rejected(const std::vector<Row> &rows)
{
  const Folder folder;
  for (const Row &row : rows)
  {
    GeometryOptions geometry = imported(folder.write("bad.msh", row.text), {"x0", "y0"});
    row.options(geometry);
    const std::string message = sentence(geometry);
    EXPECT_NE(message.find(expected(row)), std::string::npos) << row.fault << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << row.fault;
  }
}
} // namespace

TEST(BadMeshFile, GoodOnesAreTaken)
{
  const Folder folder;
  EXPECT_EQ(sentence(imported(folder.write("good.msh", good_mesh().text()), {"x0", "y0"})), "");
  EXPECT_EQ(sentence(imported(folder.write("good.msh", good_41), {})), "");
}

TEST(BadMeshFile, BrokenTextsAreRefused)
{
  expect_rejected(broken_texts());
  expect_rejected(broken_sections());
}

TEST(BadMeshFile, NumbersOfWhatIsNotThereAreRefused)
{
  expect_rejected(wrong_numbers());
}

TEST(BadMeshFile, BrokenMeshesAreRefused)
{
  // deal.II's assertions would end a debug build where its reader refuses what does not fit together.
  dealii::deal_II_exceptions::disable_abort_on_exception();
  expect_rejected(broken_meshes());
  expect_rejected(misplaced_meshes());
}

TEST(BadMeshFile, WrongNamesAreRefused)
{
  expect_rejected(wrong_names());
}

// Places, in a file with physical surfaces and in one with none.
TEST(BadMeshFile, WrongPlacesAreRefused)
{
  const auto expect = [](const std::string &file, const std::string &held, const std::string &expected)
  {
    GeometryOptions geometry = imported(file);
    geometry.contact_surfaces = {"z min"};
    geometry.held_surface = held;
    EXPECT_NE(sentence(geometry).find(expected), std::string::npos) << sentence(geometry);
  };
  const Folder folder;
  Msh box = good_mesh();
  const std::string named = folder.write("named.msh", box.text());
  const std::string places =
      "x min (0), x max (2), y min (0), y max (2), z min (0), z max (2) and other planes on its outside such "
      "as x = 0";
  expect(named, "z max", "");
  expect(named, "z = 1", "Geometry/Held surface = z = 1 has no faces: allowed in");
  expect(named, "z mx", "z mx is no physical surface: allowed in");
  expect(named, "z mx", " are base (1), top (2), side (3), x0 (4), y0 (5), each once, and " + places);
  expect(named, "z = 0", "Geometry/Held surface = z = 0 is the surface of Geometry/Contact surface, too");
  expect(named, "x = 0", "x = 0 has nodes of the contact surface");
  for (auto &element : box.elements)
    element.group = 0;
  const std::string without = folder.write("without.msh", replaced(box.text(), box.names(), ""));
  expect(without, "z max", "");
  expect(without, "top",
         ", which has no physical surfaces (gmsh: Physical Surface(\"base\") = {1}), are " + places);
}

// One message has them all, those of the elements, too.
TEST(BadMeshFile, AllFaultsAreToldAtOnce)
{
  const Folder folder;
  Msh box = good_mesh();
  box.elements[0].type = 17; // of 20 nodes
  box.elements[0].nodes.resize(20, 1);
  box.elements[1].type = 92;
  box.elements[2].type = 4;
  box.elements[2].nodes.resize(4);
  for (unsigned int &node : box.elements[3].nodes)
    node += 90;
  GeometryOptions geometry = imported(folder.write("bad.msh", box.text()), {"z0", "x = 9", "0"});
  geometry.contact_surfaces = {"bse"};
  const std::string message = sentence(geometry);
  for (const char *const fault :
       {": has 30 elements of first order beside 1 of second order", "; has elements of type 92",
        "; is mixed, of 6 hexahedra and 1 ",
        "; section $Elements has elements with nodes 95, 96, 98 and 5 more, which are not in section $Nodes",
        "; Geometry/Contact surface = bse is no physical surface",
        "; Geometry/Symmetry surfaces = z0 is no physical surface",
        "; Geometry/Symmetry surfaces = 0 is no physical surface: allowed in"})
    EXPECT_NE(message.find(fault), std::string::npos) << fault << " is missing in\n" << message;
}

TEST(BadMeshFile, AllPlacesOfAFaultAreToldAtOnce)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  const Folder folder;
  const auto low = moved([](auto &x) { x[2] -= x[2] == 0 ? 0.1 : 0; });
  EXPECT_NE(sentence(imported(folder.write("low.msh", low)))
                .find("is below the plane at (0, 0, -0.1) mm, (1, 0, -0.1) mm"),
            std::string::npos);
  const auto crossed = moved([](auto &x) { x[2] = x[2] == 1 && x[0] == 2 ? 3 : x[2]; });
  const std::string message = sentence(imported(folder.write("crossed.msh", crossed)));
  EXPECT_NE(message.find("the cells at ("), std::string::npos) << message;
  EXPECT_NE(message.find(" are inverted"), std::string::npos) << message;
}

// Wrong names are faults of other entries: most of them have a good file.
TEST(BadMeshFile, FiftyAreDifferent)
{
  std::set<std::string> files, faults, sentences;
  for (const auto &rows : {broken_texts(), broken_sections(), broken_meshes(), misplaced_meshes()})
    for (const Row &row : rows)
    {
      EXPECT_TRUE(files.insert(row.text).second) << row.fault << " has the text of another row";
      EXPECT_TRUE(faults.insert(row.fault).second) << row.fault;
      sentences.insert(row.expected);
    }
  EXPECT_EQ(files.count(good_mesh().text()) + files.count(good_41), 0U);
  EXPECT_GE(files.size(), 50U);
  EXPECT_GE(sentences.size(), 35U);
}

TEST(BadMeshFile, FoldersAndMissingFilesCannotBeRead)
{
  const Folder folder;
  EXPECT_THROW(ImportedMesh(imported(folder.path("part"))), FileError);
  EXPECT_THROW(ImportedMesh(imported(folder.path("nowhere.msh"))), FileError);
}
} // namespace orthocone::test
