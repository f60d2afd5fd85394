// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The sentences that say which name of an entry or a section was meant. Nothing here throws.
#pragma once

#include <orthocone/entries/entry.h>

#include <string>
#include <vector>

namespace orthocone
{
/// A remark on a text whose characters may not be what they look like, or "".
std::string remark(const std::string &text);

/// The entry that `name` ("Section/Entry" or "Entry") is most likely meant to be, by what other programs and
/// papers call it or by its letters, or "".
std::string nearest_entry(const std::string &name, const EntryList &list);

/// A sentence: "NAME is not an entry", the entry that is most like it, and where all are listed.
std::string not_an_entry(const std::string &name, const EntryList &list);

/// The same for a section; the name may be meant to be an entry, too.
std::string not_a_section(const std::string &name, const EntryList &list);

/// The candidate ("Section/Entry" or "Section") that `name` most likely misspells: with the fewest letters
/// inserted, deleted, exchanged or swapped, in upper or lower case. Else a candidate that has all words of
/// `name`, or all of whose words `name` has; "" if there is none.
std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates);
} // namespace orthocone
