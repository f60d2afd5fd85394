// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The sentences that tell users what is wrong with a parameter file.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace dealii
{
class ExceptionBase;
}

namespace orthocone
{
class SourceText;

/// deal.II's sentence of an exception, on one line and without its C++ stack.
std::string sentence(const dealii::ExceptionBase &exception);

/// The part of `text` between two marks ("" as the second: to the end), trimmed, or nothing.
std::optional<std::string> between(const std::string &text, const std::string &before,
                                   const std::string &after);

/// A value as messages show it: not too long.
std::string shown(const std::string &value);

/// "NAME is not an entry", the entry that is spelled most like it, and where all are listed. `name` is
/// "Section/Entry".
std::string not_an_entry(const std::string &name);

/// The same of a section.
std::string not_a_section(const std::string &name);

/// The sentence for users of a fault that deal.II found in the joined text of a .prm file.
std::string explain(const SourceText &source, const std::string &text, const std::string &file_name);

/// The candidate that `name` is most likely a misspelling of (fewest letters inserted, deleted, exchanged or
/// swapped, upper and lower case alike), or "" if none is near.
std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates);
} // namespace orthocone
