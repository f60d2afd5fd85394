// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The manifest of a run folder: the files that a run writes. RunFolder writes nothing else, and removes
// nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orthocone::run_folder
{
enum class FileKind
{
  table,       ///< grows by a row in each step or cycle
  probe_table, ///< the same; the marker names the run's own ones
  line_file,   ///< of a line after a step; the marker names the run's own lines
  file,
  checkpoint, ///< useless without the other files
  marker,     ///< stays when another run begins
};

struct RunFile
{
  /// A name; "*" stands for any text without '/', "#" for the number of a step (4 to 9 digits), "*" behind it
  /// for that of a process. "-#" behind a "*" is the last number of the name.
  const char *pattern;
  FileKind kind;
  const char *what;
  std::uintmax_t most_bytes = 100000000; ///< of those that are read as a whole

  bool fits(const std::string &name) const;
};

/// All files that a run writes.
const std::vector<RunFile> &run_files();

/// The entry of a file, or of the file that a name with ".part" will become; null for other files. This alone
/// decides what is a name of ours, whoever states it: a marker, a checkpoint, a list of pieces. Such a name
/// leads nowhere else, because it is plain or `checkpoint/state`.
const RunFile *run_file(const std::string &name);

/// The name without ".part" at its end.
std::string without_part(const std::string &name);

/// Names of the files of a kind whose names do not vary.
std::vector<std::string> fixed_names(FileKind kind);

/// The step of a field file; nothing for other files.
std::optional<unsigned long> step_of(const std::string &name);
} // namespace orthocone::run_folder
