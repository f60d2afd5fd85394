// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/parameters.h>

#include "declare.h"
#include "faults.h"
#include "source_text.h"

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/text.h>

#include <nlohmann/json.hpp>

#include <sstream>

namespace orthocone
{
namespace
{
using dealii::ParameterHandler;

void parse_prm(const std::string &file_name, ParameterHandler &handler)
{
  const SourceText source(file_name);
  if (!source.sets_anything())
    throw InputError(file_name + ": sets no entry; 'orthocone --defaults' prints a complete parameter file");
  std::istringstream stream(source.joined());
  try
  {
    handler.parse_input(stream, file_name);
  }
  catch (const dealii::ExceptionBase &exception)
  {
    throw InputError(explain(source, sentence(exception), file_name));
  }
}

/// Sets one entry; `place` tells users where it was given.
void set_entry(const std::string &place, const std::string &section, const std::string &entry,
               const std::string &value, ParameterHandler &handler)
{
  const std::string name = place + section + "/" + entry;
  handler.enter_subsection(section);
  try
  {
    handler.set(entry, value);
  }
  catch (const ParameterHandler::ExcEntryUndeclared &)
  {
    throw InputError(place + not_an_entry(section + "/" + entry));
  }
  catch (const dealii::ExceptionBase &exception)
  {
    const std::string reason = sentence(exception);
    throw InputError(name + " = " + shown(value) + ": allowed is " +
                     between(reason, "the given pattern <", ">.").value_or(reason));
  }
  handler.leave_subsection();
}

/// {"Section": {"Entry": value}}; deal.II's own reader does not tell which entry is wrong.
void parse_json(const std::string &file_name, ParameterHandler &handler)
{
  using Json = nlohmann::ordered_json;
  const std::string place = file_name + ": ";
  const std::string text = read_text_file(file_name);
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object())
    throw InputError(place + "is not valid JSON of the form {\"Section\": {\"Entry\": value}}");
  for (const auto &[section, entries] : json.items())
  {
    if (!entries.is_object())
      throw InputError(place + not_a_section(section));
    for (const auto &[entry, value] : entries.items())
      set_entry(place, section, entry, value.is_string() ? value.get<std::string>() : value.dump(), handler);
  }
}

void apply_override(const std::string &text, ParameterHandler &handler)
{
  const auto slash = text.find('/');
  const auto equals = text.find('=');
  if (slash == std::string::npos || equals == std::string::npos || slash > equals)
    throw InputError("--set " + text + ": allowed is \"Section/Entry=value\"");
  set_entry("--set: ", trimmed(text.substr(0, slash)), trimmed(text.substr(slash + 1, equals - slash - 1)),
            trimmed(text.substr(equals + 1)), handler);
}
} // namespace

Parameters read_parameters(const std::string &file_name, const std::vector<std::string> &overrides)
{
  Parameters parameters;
  ParameterHandler handler;
  declare_parameters(parameters, handler);
  const bool is_json = file_name.size() > 5 && file_name.compare(file_name.size() - 5, 5, ".json") == 0;
  is_json ? parse_json(file_name, handler) : parse_prm(file_name, handler);
  for (const std::string &text : overrides)
    apply_override(text, handler);
  return parameters;
}

std::vector<std::pair<std::string, std::string>> entry_values(const Parameters &parameters)
{
  Parameters copy = parameters;
  ParameterHandler handler;
  declare_parameters(copy, handler);
  std::ostringstream text;
  handler.print_parameters(text, ParameterHandler::ShortJSON | ParameterHandler::KeepDeclarationOrder);
  std::vector<std::pair<std::string, std::string>> values;
  const auto json = nlohmann::ordered_json::parse(text.str());
  for (const auto &[section, entries] : json.items())
    for (const auto &[entry, value] : entries.items())
      values.emplace_back(section + "/" + entry, value.get<std::string>());
  return values;
}

void write_parameters(const Parameters &parameters, std::ostream &out)
{
  Parameters copy = parameters;
  ParameterHandler handler;
  declare_parameters(copy, handler);
  handler.print_parameters(out, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
}
} // namespace orthocone
