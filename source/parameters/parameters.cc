// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/parameters.h>

#include "declare.h"
#include "source_text.h"

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/text.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <sstream>

namespace orthocone
{
namespace
{
using dealii::ParameterHandler;

constexpr const char *not_an_entry = " is not an entry; 'orthocone --defaults' lists all of them";

/// deal.II's sentence of an exception, on one line and without its C++ stack.
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

/// The part of `text` between two marks ("" as the second: to the end), or nothing. Plain searches: regular
/// expressions recurse once a character, and users' values may be long.
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

/// A value as messages show it.
std::string shown(const std::string &value)
{
  constexpr std::size_t most = 200;
  return value.size() <= most ? value : value.substr(0, most) + "...";
}

/// The number in deal.II's "Line <N> of file ...", or 0.
unsigned int line_number(const std::string &text)
{
  return parse_count(between(text, "Line <", ">").value_or("")).value_or(0);
}

/// The sentence for users of a fault that deal.II found in the joined text of a .prm file.
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
    return place + path + *unknown + not_an_entry;
  if (text.find("no such subsection") != std::string::npos)
    return place + "'" + trimmed(line.text) +
           "' opens an unknown section; 'orthocone --defaults' lists all of them";
  return place + "'" + trimmed(line.text) +
         "' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', " +
         "'end', 'include FILE' or '# comment'";
}

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
    throw InputError(name + not_an_entry);
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
      throw InputError(place + section + not_an_entry);
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

void write_parameters(const Parameters &parameters, std::ostream &out)
{
  Parameters copy = parameters;
  ParameterHandler handler;
  declare_parameters(copy, handler);
  handler.print_parameters(out, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
}
} // namespace orthocone
