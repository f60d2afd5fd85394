// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/entry.h>

namespace orthocone
{
/// A JSON schema (draft 7) of the parameter files that read_json() accepts, for editors that complete and
/// check what is typed: sections, entries with their help, defaults and units, and the words where only some
/// are allowed. Names of files have the format "path". Ranges and conditions between entries stay with the
/// program. `list` has the defaults.
std::string json_schema(const EntryList &list, const std::string &title);
} // namespace orthocone
