// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A parameter file with its includes put in place, where every line remembers where it comes from.
#pragma once

#include <string>
#include <vector>

namespace orthocone
{
struct SourceLine
{
  std::string text;
  std::string file;
  unsigned int number = 0;

  std::string place() const { return file + ":" + std::to_string(number); }
};

class SourceText
{
public:
  /// Reads `file_name` and, recursively, what its `include` lines name (paths relative to the including
  /// file). Throws FileError for what cannot be read and InputError for what is not a parameter file.
  explicit SourceText(const std::string &file_name);

  std::string joined() const;

  /// Line of the joined text, counted from 1.
  const SourceLine &line(unsigned int number) const { return lines_.at(number - 1); }

  /// Numbers of the `subsection` lines that are open before a line of the joined text.
  std::vector<unsigned int> open_sections(unsigned int number) const;

  /// "Section/" of the sections that are open before a line of the joined text.
  std::string path_at(unsigned int number) const;

  /// Whether any line sets an entry.
  bool sets_anything() const;

  unsigned int n_lines() const { return lines_.size(); }

private:
  void append(const std::string &file_name, const std::string &asked_from, unsigned int depth);

  std::vector<SourceLine> lines_;
};

/// Content of a text file. Throws FileError if it cannot be read, InputError if it is empty or binary.
/// `asked_from` is put before the message ("" or "file:line: ").
std::string read_text_file(const std::string &file_name, const std::string &asked_from = "");
} // namespace orthocone
