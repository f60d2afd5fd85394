// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "output/scratch_folder.h"

#include <orthocone/base/errors.h>
#include <orthocone/output/run_folder.h>
#include <output/posix_file.h>

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>

namespace orthocone::test
{
TEST(RunFolder, BelongsToOneRunAtATime)
{
  const ScratchFolder scratch;
  {
    RunFolder first(scratch.path);
    EXPECT_THROW(RunFolder second(scratch.path), FileError);
  }
  RunFolder third(scratch.path);
}

TEST(RunFolder, TablesAreCutBackOrLeftAlone)
{
  const ScratchFolder scratch;
  RunFolder folder(scratch.path);
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
  RunFolder folder(scratch.path);
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

namespace
{
namespace fs = std::filesystem;

void put(const fs::path &file, const std::string &text)
{
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

constexpr const char *marker = "orthocone run folder: parameter file and tables of probes\na.prm\n";
} // namespace

// Somebody else may have made the folder: its marker names tables, its checkpoint may be a link.
TEST(RunFolder, NamesNothingOutsideOfIt)
{
  const ScratchFolder scratch;
  const fs::path thesis = scratch.path / "home/thesis.csv", state = scratch.path / "home/state";
  put(thesis, "mine");
  put(state, "mine");
  const fs::path run = scratch.path / "run";
  put(run / "orthocone-run.txt", std::string(marker) + "probe-x/../../home/thesis.csv\nprobe-P.csv\n" +
                                     "../home/thesis.csv\nprobe-" + thesis.string() + "\n");
  put(run / "probe-x/a", "mine");
  put(run / "probe-P.csv", "of the run");
  {
    RunFolder folder(run);
    folder.start_anew("parameters", "b.prm", {});
    EXPECT_FALSE(folder.has("probe-P.csv"));
    EXPECT_TRUE(fs::exists(thesis));
    EXPECT_THROW(folder.read("probe-x/../../home/thesis.csv"), FileError);
    EXPECT_THROW(folder.remove("probe-x/../../home/thesis.csv"), FileError);
    EXPECT_THROW(folder.require_tables({{"../home/thesis.csv", {}}}), FileError);
    EXPECT_THROW(folder.require_tables({{"parameters.prm", {}}}), FileError) << "is no table";
  }
  fs::create_directory_symlink(scratch.path / "home", run / "checkpoint");
  RunFolder folder(run);
  EXPECT_THROW(folder.start_anew("parameters", "b.prm", {}), FileError);
  EXPECT_THROW(folder.write_durably("checkpoint/state", "new"), FileError);
  EXPECT_THROW(folder.remove("checkpoint/state"), FileError);
  EXPECT_EQ(posix::head(state, 9), "mine");
}

// Users may have measured along a line, and call their file as the run calls its own.
TEST(RunFolder, RemovesFilesOfItsOwnLinesOnly)
{
  const ScratchFolder scratch;
  const fs::path run = scratch.path / "run";
  put(run / "orthocone-run.txt", std::string(marker) + "line-P-#.csv\n");
  for (const char *const name : {"line-P-0001.csv", "line-P-0012.csv", "line-P-0013.csv.part"})
    put(run / name, "of the run");
  for (const char *const name : {"line-P2-2024.csv", "line-P-2-2024.csv", "line-Q-0013.csv"})
    put(run / name, "mine");
  RunFolder folder(run);
  folder.require_own({"line-P-#.csv", "line-R-#.csv"});
  EXPECT_THROW(folder.require_own({"line-Q-#.csv"}), FileError);
  folder.remove_fields_after(5);
  EXPECT_TRUE(folder.has("line-P-0001.csv"));
  EXPECT_FALSE(folder.has("line-P-0012.csv"));
  folder.start_anew("parameters", "a.prm", {"line-R-#.csv"});
  EXPECT_FALSE(folder.has("line-P-0001.csv"));
  EXPECT_FALSE(fs::exists(run / "line-P-0013.csv.part"));
  for (const char *const name : {"line-P2-2024.csv", "line-P-2-2024.csv", "line-Q-0013.csv"})
    EXPECT_TRUE(folder.has(name)) << name;
}

TEST(RunFolder, CutsAndReadsNoLinks)
{
  const ScratchFolder scratch;
  const fs::path thesis = scratch.path / "home/thesis.csv";
  put(thesis, "mine");
  fs::create_directories(scratch.path / "run");
  fs::create_symlink(thesis, scratch.path / "run/history.csv");
  RunFolder folder(scratch.path / "run");
  EXPECT_THROW(folder.cut_tables({{"history.csv", {}}}), FileError); // a mark of 0 bytes fits any file
  EXPECT_THROW(folder.append("history.csv", "row\n"), FileError);
  EXPECT_THROW(folder.read("history.csv"), FileError);
  EXPECT_EQ(posix::head(thesis, 9), "mine");
}

// A pipe would be waited for, a device never ends, and what is too large fills the memory.
TEST(RunFolder, ReadsAndWritesOrdinaryFilesOnly)
{
  const ScratchFolder scratch;
  fs::create_directories(scratch.path / "checkpoint");
  for (const char *const name : {"orthocone-run.txt", "history.csv", "log.txt", "checkpoint/state"})
    ASSERT_EQ(::mkfifo((scratch.path / name).c_str(), 0600), 0);
  put(scratch.path / "summary.json", "");
  fs::resize_file(scratch.path / "summary.json", 10000000000);
  RunFolder folder(scratch.path);
  for (const char *const name : {"orthocone-run.txt", "history.csv", "checkpoint/state", "summary.json"})
    EXPECT_THROW(folder.read(name), FileError) << name;
  EXPECT_THROW(folder.ends_with("history.csv", "\n"), FileError);
  EXPECT_THROW(folder.require_tables({{"history.csv", {1, 0}}}), FileError);
  EXPECT_THROW(folder.append("log.txt", "line\n"), FileError);
  EXPECT_THROW(folder.require_own({}), FileError);
}

TEST(RunFolder, IsNoFolderOfTheSystem)
{
  for (const char *const name : {"/", "/etc", "/usr/share", "/etc/../etc/x", "/proc/self/fd", "/dev"})
    EXPECT_THROW(RunFolder folder{std::optional(fs::path(name))}, FileError) << name;
  EXPECT_FALSE(fs::exists("/etc/x"));
}

// What the list of files lacks would outlive the run and be taken for a user's file by the next one.
TEST(RunFolder, WritesOnlyWhatIsListed)
{
  const ScratchFolder scratch;
  RunFolder folder(scratch.path);
  EXPECT_THROW(folder.write("notes.txt", ""), std::logic_error);
  EXPECT_THROW(folder.append("wear.csv", ""), std::logic_error);
  EXPECT_FALSE(folder.has("notes.txt"));
  EXPECT_FALSE(folder.has("wear.csv"));
}
} // namespace orthocone::test
