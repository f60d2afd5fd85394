// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/files.h>

#include "readers.h"

#include <orthocone/base/errors.h>
#include <orthocone/entries/names.h>

#include <deal.II/base/utilities.h>

#include <cctype>
#include <filesystem>
#include <ostream>

namespace orthocone
{
namespace
{
/// Length of the longest name of an entry in a section.
std::size_t longest_name(const EntryList &list, const std::string &section)
{
  std::size_t longest = 0;
  for (const Entry &entry : list.entries())
    if (entry.section() == section)
      longest = std::max(longest, entry.own_name().size());
  return longest;
}
} // namespace

void set_entry(const std::string &name, const std::string &value, const std::string &place,
               const std::string &file, EntryList &list)
{
  Entry *const entry = list.find(name);
  if (entry == nullptr)
    throw InputError(place + not_an_entry(name, list));
  entry->set(value, place, file);
}

std::string sets_no_entry(const std::string &file_name)
{
  return shown_path(file_name) + ": sets no entry; 'orthocone --defaults' prints a complete parameter file";
}

bool is_json(const std::string &file_name)
{
  std::string ending = std::filesystem::path(file_name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](const unsigned char c) { return std::tolower(c); });
  return ending == ".json";
}

std::string read_entries(const std::string &file_name, EntryList &list)
{
  return is_json(file_name) ? read_json(file_name, list) : read_prm(file_name, list);
}

void assign_entry(const std::string &assignment, EntryList &list)
{
  const auto equals = assignment.find('=');
  const std::string name = trimmed(assignment.substr(0, equals));
  const auto slash = name.find('/');
  if (slash == std::string::npos || equals == std::string::npos)
  {
    const std::string nearest = nearest_entry(name, list);
    throw InputError("--set " + shown(assignment) + ": allowed is \"Section/Entry=value\"" +
                     (nearest.empty() ? "" : "; is " + nearest + " meant?"));
  }
  set_entry(trimmed(name.substr(0, slash)) + "/" + trimmed(name.substr(slash + 1)),
            trimmed(assignment.substr(equals + 1)), "--set: ", "", list);
}

void restore_entry(const std::string &name, const std::string &text, EntryList &list)
{
  set_entry(name, text, "", "", list);
}

void print_entries(const EntryList &list, std::ostream &out)
{
  constexpr int width = 74; // of the help, so that lines have at most 78 characters
  out << "# Listing of Parameters\n# ---------------------\n";
  std::string section;
  for (const Entry &entry : list.entries())
  {
    if (!section.empty() && entry.section() != section)
      out << "end\n\n\n";
    out << (entry.section() != section ? "subsection " + entry.section() : "") << "\n";
    section = entry.section();
    for (const std::string &line : dealii::Utilities::break_text_into_lines(entry.help(), width))
      out << "  # " << line << "\n";
    const std::string name = entry.own_name();
    out << "  set " << name << std::string(longest_name(list, section) - name.size(), ' ') << " = "
        << entry.text() << "\n";
  }
  out << "end\n\n\n";
}
} // namespace orthocone
