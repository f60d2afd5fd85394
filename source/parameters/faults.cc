// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "faults.h"

#include "source_text.h"

#include <orthocone/parameters/parameters.h>
#include <orthocone/parameters/text.h>

#include <deal.II/base/exceptions.h>

#include <sstream>

namespace orthocone
{
namespace
{
/// The number in deal.II's "Line <N> of file ...", or 0.
unsigned int line_number(const std::string &text)
{
  return parse_count(between(text, "Line <", ">").value_or("")).value_or(0);
}

std::vector<std::string> entry_names()
{
  std::vector<std::string> names;
  for (const auto &[name, value] : entry_values(Parameters()))
    names.push_back(name);
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

std::string not_known(const std::string &kind, const std::string &name, const std::vector<std::string> &known)
{
  const std::string nearest = nearest_name(name, known);
  return shown(name) + " is not " + kind + (nearest.empty() ? "; " : "; is " + nearest + " meant? ") +
         "'orthocone --defaults' lists all of them";
}
} // namespace

std::string sentence(const dealii::ExceptionBase &exception)
{
  std::ostringstream text;
  exception.print_info(text);
  std::istringstream words(text.str());
  std::string line;
  for (std::string word; words >> word;)
    line += (line.empty() ? "" : " ") + word;
  return line;
}

// Plain searches: regular expressions recurse once a character, and users' values may be long.
std::optional<std::string> between(const std::string &text, const std::string &before,
                                   const std::string &after)
{
  const auto found = text.find(before);
  if (found == std::string::npos)
    return std::nullopt;
  const auto first = found + before.size();
  const auto last = after.empty() ? text.size() : text.find(after, first);
  if (last == std::string::npos)
    return std::nullopt;
  return trimmed(text.substr(first, last - first));
}

std::string shown(const std::string &value)
{
  constexpr std::size_t most = 200;
  return value.size() <= most ? value : value.substr(0, most) + "...";
}

std::string not_an_entry(const std::string &name)
{
  return not_known("an entry", name, entry_names());
}

std::string not_a_section(const std::string &name)
{
  return not_known("a section", name, section_names());
}

std::string explain(const SourceText &source, const std::string &text, const std::string &file_name)
{
  const unsigned int number = line_number(text);
  if (number == 0)
  {
    const auto open = source.open_sections(source.n_lines() + 1);
    return open.empty() ? file_name + ": " + text
                        : source.line(open.back()).place() + ": '" + trimmed(source.line(open.back()).text) +
                              "' has no 'end'";
  }
  const SourceLine &line = source.line(number);
  const std::string place = line.place() + ": ";
  const std::string path = source.path_at(number);
  constexpr const char *mismatch = "does not match the given pattern:";
  if (const auto entry = between(text, "for the entry named", mismatch))
    return place + path + *entry + " = " + shown(*between(text, "The entry value", "for the entry named")) +
           ": allowed is " + *between(text, mismatch, "");
  if (const auto unknown = between(text, "No entry with name <", "> was declared"))
    return place + not_an_entry(path + *unknown);
  if (text.find("no such subsection") != std::string::npos)
    return place + not_a_section(path + trimmed(trimmed(line.text).substr(std::string("subsection").size())));
  return place + "'" + shown(trimmed(line.text)) +
         "' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', " +
         "'end', 'include FILE' or '# comment'";
}
} // namespace orthocone
