// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>
#include <vector>

namespace orthocone
{
/// The options of the command line.
struct CommandLine
{
  std::string parameter_file;
  std::vector<std::string> overrides;
  std::string output_folder; ///< empty: output/<stem of the parameter file>
  unsigned int threads = 0;  ///< 0: the program chooses
  bool batch = false;        ///< command lines come from standard input
  unsigned int jobs = 0;     ///< of these, at a time; 0: one after the other
  bool check = false;
  std::string picture; ///< file that --check draws the scene to; empty: none
  bool resume = false;
  bool insist = false; ///< runs even if memory is not likely to suffice
  bool quiet = false;
  bool defaults = false;
  std::string rig;      ///< that --new copies to `parameter_file`
  bool list = false;    ///< prints the parameter files that come with the program
  bool schema = false;  ///< prints a JSON schema of parameter files
  bool columns = false; ///< prints the columns of the tables, and the fields
  bool help = false;
  bool version = false;

  /// Whether only a text is asked for.
  bool prints() const { return defaults || list || schema || columns || help || version; }
};

/// Throws InputError for words that are not understood.
CommandLine parse_command_line(int argc, const char *const *argv);

std::string usage();
} // namespace orthocone
