// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/names.h>

#include <algorithm>
#include <cctype>

namespace orthocone
{
namespace
{
std::string not_known(const std::string &kind, const std::string &name, const std::string &nearest)
{
  return (name.empty() ? "''" : shown(name)) + remark(name) + " is not " + kind +
         (nearest.empty() ? "; " : "; is " + nearest + " meant? ") +
         "'orthocone --defaults' lists all of them";
}

/// The entry that other programs and papers call `name` ("Section/Word" or "Word"), or "".
std::string entry_of_synonym(const std::string &name, const EntryList &list)
{
  std::string word = name.substr(name.rfind('/') + 1);
  std::transform(word.begin(), word.end(), word.begin(),
                 [](const unsigned char c) { return std::tolower(c); });
  for (const Entry &entry : list.entries())
    if (std::find(entry.synonyms().begin(), entry.synonyms().end(), word) != entry.synonyms().end())
      return entry.name();
  return {};
}
} // namespace

std::string remark(const std::string &text)
{
  const bool is_ascii = std::all_of(text.begin(), text.end(), [](const unsigned char c) { return c < 0x80; });
  return is_ascii ? "" : " (with characters beyond ASCII)";
}

std::string nearest_entry(const std::string &name, const EntryList &list)
{
  const std::string meant = entry_of_synonym(name, list);
  return meant.empty() ? nearest_name(name, list.names()) : meant;
}

std::string not_an_entry(const std::string &name, const EntryList &list)
{
  return not_known("an entry", name, nearest_entry(name, list));
}

std::string not_a_section(const std::string &name, const EntryList &list)
{
  const std::string section = nearest_name(name, list.sections());
  return not_known("a section", name, section.empty() ? nearest_entry(name, list) : section);
}
} // namespace orthocone
