// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/parameters.h>

#include "declare.h"
#include "source_text.h"

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/text.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <regex>
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
  return trimmed(std::regex_replace(text.str(), std::regex("\\s+"), " "));
}

/// The number in deal.II's "Line <N> of file ...", or 0.
unsigned int line_number(const std::string &text)
{
  std::smatch match;
  return std::regex_search(text, match, std::regex("Line <(\\d+)>")) ? *parse_count(match[1].str()) : 0;
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
  std::smatch match;
  if (std::regex_search(text, match,
                        std::regex("entry value ?(.*) for the entry named (.*) does not match the given "
                                   "pattern: ?(.*)")))
    return place + path + match[2].str() + " = " + trimmed(match[1].str()) + ": allowed is " + match[3].str();
  if (std::regex_search(text, match, std::regex("No entry with name <(.*)> was declared")))
    return place + path + match[1].str() + not_an_entry;
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
    std::smatch match;
    const std::string reason = sentence(exception);
    const bool is_pattern = std::regex_search(reason, match, std::regex("given pattern <(.*)>\\."));
    throw InputError(name + " = " + value + ": allowed is " + (is_pattern ? match[1].str() : reason));
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

void check_parameters(const Parameters &parameters)
{
  const MeshOptions &mesh = parameters.mesh;
  if (mesh.n_quadrature_points() <= mesh.degree)
    throw InputError("Mesh/Quadrature points = " + std::to_string(mesh.quadrature_points) +
                     ": with Mesh/Degree = " + std::to_string(mesh.degree) +
                     " allowed is 0 or more than the degree (fewer points leave " +
                     "deformations without stiffness)");
  const LoadOptions &load = parameters.load;
  if (load.preload.empty() && (load.legs.empty() || load.cycles == 0))
    throw InputError((load.legs.empty() ? "Load program/Legs is empty" : "Load program/Cycles = 0") +
                     std::string(" and Load program/Preload is empty: allowed is at least one leg, such as "
                                 "'0 0 -0.1 : 5'"));
  constexpr double rounding = 1e-12;
  for (const Probe &probe : parameters.output.probes)
    if (std::hypot(probe.position[0], probe.position[1]) > (1 + rounding) * parameters.geometry.radius)
      throw InputError("Output/Probes: '" + probe.name + "' at (" + to_text(probe.position[0]) + ", " +
                       to_text(probe.position[1]) +
                       ") is off the contact surface: allowed are points within " +
                       "Geometry/Radius = " + to_text(parameters.geometry.radius) + " of the axis");
}
} // namespace orthocone
