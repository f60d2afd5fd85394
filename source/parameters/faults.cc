// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "faults.h"

#include <orthocone/base/text.h>
#include <orthocone/parameters/parameters.h>

#include <algorithm>

namespace orthocone
{
namespace
{
std::vector<std::string> all_entries()
{
  std::vector<std::string> names;
  for (const auto &[name, value] : entry_values(Parameters()))
    names.push_back(name);
  return names;
}

const std::vector<std::string> &entry_names()
{
  static const std::vector<std::string> names = all_entries();
  return names;
}

std::vector<std::string> section_names()
{
  std::vector<std::string> names;
  for (const std::string &name : entry_names())
    if (const std::string section = name.substr(0, name.find('/')); names.empty() || names.back() != section)
      names.push_back(section);
  return names;
}

bool is_one_of(const std::string &name, const std::vector<std::string> &names)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string not_known(const std::string &kind, const std::string &name, const std::string &nearest)
{
  return (name.empty() ? "''" : shown(name)) + remark(name) + " is not " + kind +
         (nearest.empty() ? "; " : "; is " + nearest + " meant? ") +
         "'orthocone --defaults' lists all of them";
}

} // namespace

std::string remark(const std::string &text)
{
  const bool is_ascii = std::all_of(text.begin(), text.end(), [](const unsigned char c) { return c < 0x80; });
  return is_ascii ? "" : " (with characters beyond ASCII)";
}

bool is_entry(const std::string &name)
{
  return is_one_of(name, entry_names());
}

bool is_section(const std::string &name)
{
  return is_one_of(name, section_names());
}

std::string nearest_entry(const std::string &name)
{
  const std::string meant = entry_for_word(name);
  return meant.empty() ? nearest_name(name, entry_names()) : meant;
}

std::string not_an_entry(const std::string &name)
{
  return not_known("an entry", name, nearest_entry(name));
}

std::string not_a_section(const std::string &name)
{
  const std::string section = nearest_name(name, section_names());
  return not_known("a section", name, section.empty() ? nearest_entry(name) : section);
}
} // namespace orthocone
