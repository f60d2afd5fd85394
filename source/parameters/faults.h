// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The sentences that say what is wrong with a parameter file.
#pragma once

#include <string>
#include <vector>

namespace orthocone
{
/// A remark on a text whose characters may not be what they look like, or "".
std::string remark(const std::string &text);

/// Whether there is an entry "Section/Entry".
bool is_entry(const std::string &name);

bool is_section(const std::string &name);

/// The entry that `name` ("Section/Entry" or "Entry") is most likely meant to be, or "".
std::string nearest_entry(const std::string &name);

/// The entry for what other programs and papers call `name` ("Section/Word" or "Word"), such as mu, E or
/// diameter, or "".
std::string entry_for_word(const std::string &name);

/// A sentence: "NAME is not an entry", the entry that is most like it, and where all are listed.
std::string not_an_entry(const std::string &name);

/// The same for a section; the name may be meant to be an entry, too.
std::string not_a_section(const std::string &name);

/// The candidate ("Section/Entry" or "Section") that `name` most likely misspells: with the fewest letters
/// inserted, deleted, exchanged or swapped, in upper or lower case. Else a candidate that has all words of
/// `name`, or all of whose words `name` has; "" if there is none.
std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates);
} // namespace orthocone
