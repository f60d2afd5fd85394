// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The manifest of a run folder: the files that a run writes. RunFolder writes nothing else, and removes
// nothing else.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace orthocone::run_folder
{
enum class FileKind
{
  table,       ///< grows by a row in each step or cycle
  probe_table, ///< the same; the marker names the run's own ones
  file,
  checkpoint, ///< useless without the other files
  marker,     ///< stays when another run begins
};

struct RunFile
{
  /// A name; "*" stands for any text, "#" for the number of a step (4 to 9 digits), "*" behind it for that of
  /// a process.
  const char *pattern;
  FileKind kind;
  const char *what;

  bool fits(const std::string &name) const;
};

/// All files that a run writes.
const std::vector<RunFile> &run_files();

/// The entry of a file, or of the file that a name with ".part" will become; null for other files.
const RunFile *run_file(const std::string &name);

/// Names of the files of a kind whose names do not vary.
std::vector<std::string> fixed_names(FileKind kind);

/// The step of a field file; nothing for other files.
std::optional<unsigned long> step_of(const std::string &name);
} // namespace orthocone::run_folder
