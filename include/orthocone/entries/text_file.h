// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <string>

namespace orthocone
{
/// The purpose of a text file, as messages name it, and its limits.
struct TextFileKind
{
  const char *name;
  std::size_t most_megabytes;
  const char *if_empty;
};

constexpr TextFileKind parameter_text{
    "a parameter file (.prm or .json)", 4,
    "'orthocone --defaults' prints a complete parameter file to start from"};
constexpr TextFileKind gap_grid_file{"a text file with a grid of gaps", 100, "a grid of gaps is wanted"};

/// Content of a text file, byte for byte. It may be a pipe or a device and is read once, up to the megabytes
/// of its kind; a pipe without a writer is read for five seconds. Throws FileError if it cannot be read,
/// InputError if it is empty, binary or larger; their messages begin with `asked_from` ("" or "file:line: ").
std::string read_text_file(const std::string &file_name, const std::string &asked_from = "",
                           const TextFileKind &kind = parameter_text);

/// The text without a byte-order mark and with '\n' at the end of lines, whatever wrote it.
std::string with_plain_lines(const std::string &content);
} // namespace orthocone
