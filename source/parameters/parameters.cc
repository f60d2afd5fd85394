// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/parameters.h>

#include "declare.h"
#include "faults.h"
#include "readers.h"

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

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
  std::ostringstream text;
  table.handler().print_parameters(text, dealii::ParameterHandler::ShortJSON |
                                             dealii::ParameterHandler::KeepDeclarationOrder);
  std::vector<std::pair<std::string, std::string>> values;
  const auto json = nlohmann::ordered_json::parse(text.str());
  for (const auto &[section, entries] : json.items())
    for (const auto &[entry, value] : entries.items())
      values.emplace_back(section + "/" + entry, value.get<std::string>());
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
  Parameters copy = parameters;
  EntryTable table;
  declare_parameters(copy, table);
  table.handler().print_parameters(out, dealii::ParameterHandler::PRM |
                                            dealii::ParameterHandler::KeepDeclarationOrder);
}
} // namespace orthocone
