// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "output/scratch_folder.h"

#include <orthocone/base/errors.h>
#include <orthocone/output/run_folder.h>
#include <output/posix_file.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace orthocone::test
{
TEST(RunFolder, BelongsToOneRunAtATime)
{
  const ScratchFolder scratch;
  {
    const RunFolder first(scratch.path);
    EXPECT_THROW(RunFolder second(scratch.path), FileError);
  }
  const RunFolder third(scratch.path);
}

TEST(RunFolder, TablesAreCutBackOrLeftAlone)
{
  const ScratchFolder scratch;
  const RunFolder folder(scratch.path);
  folder.append("history.csv", "one\n");
  folder.append("probe-P.csv", "one\n");
  const auto marks = folder.tables();
  folder.append("history.csv", "two\nthr");
  folder.append("timing.csv", "later\n");
  auto too_large = marks;
  too_large["probe-P.csv"].size = 100;
  EXPECT_THROW(folder.require_tables(too_large), FileError);
  EXPECT_THROW(folder.cut_tables(too_large), FileError);
  EXPECT_EQ(folder.read("history.csv"), "one\ntwo\nthr");
  folder.cut_tables(marks);
  EXPECT_EQ(folder.read("history.csv"), "one\n");
  EXPECT_EQ(folder.tables(), marks);
  EXPECT_FALSE(folder.has("timing.csv"));
}

// A file of megabytes is not read whole to see how it begins.
TEST(RunFolder, FilesAreReadInPieces)
{
  const ScratchFolder scratch;
  const RunFolder folder(scratch.path);
  std::string text;
  for (unsigned int line = 0; line < 30000; ++line)
    text += std::to_string(line) + "\n";
  folder.append("history.csv", text);
  const std::filesystem::path file = scratch.path / "history.csv";
  EXPECT_EQ(posix::head(file, 5), text.substr(0, 5));
  EXPECT_EQ(posix::head(file, 2 * text.size()), text);
  std::string again;
  std::size_t n_pieces = 0;
  const auto add = [&](const char *const piece, const std::size_t n)
  {
    again.append(piece, n);
    ++n_pieces;
  };
  EXPECT_TRUE(posix::read_pieces(file, text.size() - 3, add));
  EXPECT_EQ(again, text.substr(0, text.size() - 3));
  EXPECT_GT(n_pieces, 1u);
  EXPECT_FALSE(posix::read_pieces(file, text.size() + 1, add));
  EXPECT_THROW(posix::head(scratch.path / "missing", 5), FileError);
  EXPECT_THROW(posix::head(scratch.path, 5), FileError);
  const TableMarks marks = folder.tables();
  EXPECT_NO_THROW(folder.require_tables(marks));
  folder.append("history.csv", "more\n");
  EXPECT_NO_THROW(folder.require_tables(marks)); // they begin with what they were
}

// What the list of files lacks would outlive the run and be taken for a user's file by the next one.
TEST(RunFolder, WritesOnlyWhatIsListed)
{
  const ScratchFolder scratch;
  const RunFolder folder(scratch.path);
  EXPECT_THROW(folder.write("notes.txt", ""), std::logic_error);
  EXPECT_THROW(folder.append("wear.csv", ""), std::logic_error);
  EXPECT_FALSE(folder.has("notes.txt"));
  EXPECT_FALSE(folder.has("wear.csv"));
}
} // namespace orthocone::test
