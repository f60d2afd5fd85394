// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "faults.h"

#include "text_file.h"

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
  return shown(name) + remark(name) + " is not " + kind +
         (nearest.empty() ? "; " : "; is " + nearest + " meant? ") +
         "'orthocone --defaults' lists all of them";
}

/// The first bytes of `text`, at most `most`, without a part of a UTF-8 character at the end.
std::string beginning(const std::string &text, const std::size_t most)
{
  constexpr std::size_t longest_character = 4;
  std::size_t size = most;
  while (size + longest_character > most && continues_character(text[size]))
    --size;
  return text.substr(0, size);
}

bool is_control(const unsigned char c)
{
  constexpr unsigned char blank = 0x20, del = 0x7f;
  return c < blank || c == del;
}

/// A control character as in C and JSON, others as they are.
std::string printable(const unsigned char c)
{
  constexpr const char *digits = "0123456789abcdef";
  if (!is_control(c))
    return {static_cast<char>(c)};
  if (c == '\n' || c == '\t' || c == '\r')
    return c == '\n' ? "\\n" : c == '\t' ? "\\t" : "\\r";
  return {'\\', 'x', digits[c / 16], digits[c % 16]};
}
} // namespace

std::string shown(const std::string &text)
{
  constexpr std::size_t most = 200;
  std::string result;
  for (const char c : text.size() <= most ? text : beginning(text, most))
    result += printable(static_cast<unsigned char>(c));
  return result + (text.size() <= most ? "" : "...");
}

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
  return nearest_name(name, entry_names());
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
