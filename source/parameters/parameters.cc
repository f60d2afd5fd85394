// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/parameters.h>

#include "declare.h"
#include "faults.h"
#include "readers.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <ostream>

namespace orthocone
{
namespace
{
void apply_override(const std::string &text, EntryTable &table)
{
  const auto equals = text.find('=');
  const std::string name = trimmed(text.substr(0, equals));
  const auto slash = name.find('/');
  if (slash == std::string::npos || equals == std::string::npos)
  {
    const std::string nearest = nearest_entry(name);
    throw InputError("--set " + shown(text) + ": allowed is \"Section/Entry=value\"" +
                     (nearest.empty() ? "" : "; is " + nearest + " meant?"));
  }
  set_entry("--set: ", trimmed(name.substr(0, slash)) + "/" + trimmed(name.substr(slash + 1)),
            trimmed(text.substr(equals + 1)), table);
}

/// Length of the longest name of an entry in a section.
std::size_t longest_name(const std::vector<Entry> &entries, const std::string &section)
{
  std::size_t longest = 0;
  for (const Entry &entry : entries)
    if (entry.section() == section)
      longest = std::max(longest, entry.own_name().size());
  return longest;
}
} // namespace

bool is_json(const std::string &file_name)
{
  std::string ending = std::filesystem::path(file_name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](const unsigned char c) { return std::tolower(c); });
  return ending == ".json";
}

ParameterFile read_parameter_file(const std::string &file_name, const std::vector<std::string> &overrides)
{
  ParameterFile file;
  EntryTable table;
  declare_parameters(file.parameters, table);
  file.text = is_json(file_name) ? read_json(file_name, table) : read_prm(file_name, table);
  table.read_from("");
  for (const std::string &text : overrides)
    apply_override(text, table);
  return file;
}

Parameters read_parameters(const std::string &file_name, const std::vector<std::string> &overrides)
{
  return read_parameter_file(file_name, overrides).parameters;
}

std::vector<std::pair<std::string, std::string>> entry_values(const Parameters &parameters)
{
  Parameters copy = parameters;
  EntryTable table;
  declare_parameters(copy, table);
  std::vector<std::pair<std::string, std::string>> values;
  for (const Entry &entry : table.entries())
    values.emplace_back(entry.name, entry.text);
  return values;
}

Parameters with_section(const Parameters &parameters, const std::string &section,
                        const std::vector<std::pair<std::string, std::string>> &values)
{
  Parameters changed = parameters;
  EntryTable table;
  declare_parameters(changed, table);
  for (const auto &[entry, value] : values)
    if (entry.compare(0, section.size() + 1, section + "/") == 0)
      set_entry("", entry, value, table);
  return changed;
}

void write_parameters(const Parameters &parameters, std::ostream &out)
{
  constexpr int width = 74; // of the help, so that lines have at most 78 characters
  Parameters copy = parameters;
  EntryTable table;
  declare_parameters(copy, table);
  out << "# Listing of Parameters\n# ---------------------\n";
  const std::vector<Entry> &entries = table.entries();
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const Entry &entry = entries[i];
    const bool is_first = i == 0 || entries[i - 1].section() != entry.section();
    out << (is_first ? "subsection " + entry.section() : "") << "\n";
    for (const std::string &line : dealii::Utilities::break_text_into_lines(entry.help, width))
      out << "  # " << line << "\n";
    const std::string name = entry.own_name();
    out << "  set " << name << std::string(longest_name(entries, entry.section()) - name.size(), ' ') << " = "
        << entry.text << "\n";
    if (i + 1 == entries.size() || entries[i + 1].section() != entry.section())
      out << "end\n\n\n";
  }
}
} // namespace orthocone
