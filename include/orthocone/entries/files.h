// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/entry.h>

#include <iosfwd>
#include <string>

namespace orthocone
{
/// Sets entries from a .prm or .json file. A line `include FILE` of a .prm file reads FILE, relative to the
/// folder of the including file, in its place. The file is read once, so it may be a pipe. Returns its text
/// as written, with the included files in their place, so that it can be read from any folder. Throws
/// InputError (one sentence: file and line, entry, value given, what is allowed) or FileError.
std::string read_entries(const std::string &file_name, EntryList &list);

/// Sets an entry from "Section/Entry=value". Throws InputError.
void assign_entry(const std::string &assignment, EntryList &list);

/// Sets the entry "Section/Entry" from a text that the program itself has written. Throws InputError.
void restore_entry(const std::string &name, const std::string &text, EntryList &list);

/// Writes a complete, commented .prm file. Throws nothing; `out` has the state of the stream.
void print_entries(const EntryList &list, std::ostream &out);

/// Whether a parameter file is JSON, by the ending of its name.
bool is_json(const std::string &file_name);
} // namespace orthocone
