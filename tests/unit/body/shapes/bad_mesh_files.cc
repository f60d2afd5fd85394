// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "bad_meshes.h"

#include "parameters/parameter_files.h"
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
  Parameters parameters;
  parameters.geometry = geometry;
  return rejection_of(
      [&]
      {
        check_parameters(parameters);
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
