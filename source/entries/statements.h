// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The language of .prm files. It is deal.II's, read here line by line so that every fault is reported with
// its file and line. deal.II's own reader cannot do this for included files.
#pragma once

#include <orthocone/entries/entry.h>

#include <string>
#include <vector>

namespace orthocone
{
struct Statement
{
  enum class Kind
  {
    subsection,
    set,
    end,
  };

  Kind kind;
  std::string place;   ///< "file:line" of its first line
  std::string file;    ///< path
  std::string name{};  ///< of the section or entry
  std::string value{}; ///< of the entry
};

/// A .prm file with the included files (paths relative to the including file) in their place.
struct StatementFile
{
  std::vector<Statement> statements;
  /// As written, with included files between two comments and the whole paths of files that entries name.
  std::string text;
};

/// Reads a .prm file, whose list says which entries name files. Throws FileError if it cannot be read, and
/// InputError for lines that are no statements.
StatementFile read_statements(const std::string &file_name, const EntryList &list);
} // namespace orthocone
