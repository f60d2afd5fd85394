// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The two kinds of parameter files. All readers throw InputError for faults of the content, and FileError for
// files that cannot be read.
#pragma once

#include <orthocone/entries/entry.h>

namespace orthocone
{
/// Returns the text with the included files in it.
std::string read_prm(const std::string &file_name, EntryList &list);

/// {"Section": {"Entry": value}}
/// Returns the text.
std::string read_json(const std::string &file_name, EntryList &list);

/// Sets the entry `name` ("Section/Entry"), which `file` has at `place` ("file:line: ").
void set_entry(const std::string &name, const std::string &value, const std::string &place,
               const std::string &file, EntryList &list);

/// The message on a file without any setting.
std::string sets_no_entry(const std::string &file_name);
} // namespace orthocone
