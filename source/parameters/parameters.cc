// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/parameters.h>

#include "declare.h"
#include "source_text.h"

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/text.h>

#include <cmath>
#include <regex>
#include <sstream>

namespace orthocone
{
namespace
{
using dealii::ParameterHandler;

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

/// Entry and value of a line "set Entry = value # comment".
std::pair<std::string, std::string> entry_and_value(const std::string &line)
{
  const std::string text = trimmed(line.substr(0, line.find('#')));
  const auto equals = text.find('=');
  const std::string name = trimmed(text.substr(0, equals));
  const std::string value = equals == std::string::npos ? "" : trimmed(text.substr(equals + 1));
  return {name.rfind("set ", 0) == 0 ? trimmed(name.substr(4)) : name, value};
}

/// The pattern in deal.II's "does not match the given pattern: [...]".
std::string pattern_of(const std::string &text)
{
  std::smatch match;
  return std::regex_search(text, match, std::regex("given pattern: ?\\[(.*)\\]")) ? match[1].str() : text;
}

/// The sentence for users of a fault that deal.II found in the joined text of a .prm file.
std::string explain(const SourceText &source, const std::string &text, const std::string &file_name)
{
  const unsigned int number = line_number(text);
  if (number == 0)
    return file_name + ": " +
           (text.find("unequal numbers") != std::string::npos ? "every 'subsection' needs one 'end'" : text);
  const SourceLine &line = source.line(number);
  const auto [entry, value] = entry_and_value(line.text);
  const std::string place = line.place() + ": ";
  const std::string name = source.section_at(number) + entry;
  if (text.find("does not match the given pattern") != std::string::npos)
    return place + name + " = " + value + ": allowed is " + pattern_of(text);
  if (text.find("No entry with name") != std::string::npos)
    return place + name + " is not an entry; 'orthocone --defaults' lists all of them";
  if (text.find("no such subsection") != std::string::npos)
    return place + "'" + trimmed(line.text) + "' opens an unknown section; 'orthocone --defaults' lists all of them";
  return place + "'" + trimmed(line.text) + "' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', " +
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

void parse_json(const std::string &file_name, ParameterHandler &handler)
{
  std::istringstream stream(read_text_file(file_name));
  try
  {
    handler.parse_input_from_json(stream);
  }
  catch (const dealii::ExceptionBase &exception)
  {
    throw InputError(file_name + ": " + sentence(exception));
  }
  catch (const std::exception &exception)
  {
    throw InputError(file_name + ": is not valid JSON (" + trimmed(exception.what()) + ")");
  }
}

void apply_override(const std::string &text, ParameterHandler &handler)
{
  const auto slash = text.find('/');
  const auto equals = text.find('=');
  if (slash == std::string::npos || equals == std::string::npos || slash > equals)
    throw InputError("--set " + text + ": allowed is \"Section/Entry=value\"");
  const std::string section = trimmed(text.substr(0, slash));
  const std::string entry = trimmed(text.substr(slash + 1, equals - slash - 1));
  const std::string value = trimmed(text.substr(equals + 1));
  const std::string place = "--set: " + section + "/" + entry;
  handler.enter_subsection(section);
  try
  {
    handler.set(entry, value);
  }
  catch (const ParameterHandler::ExcEntryUndeclared &)
  {
    throw InputError(place + " is not an entry; 'orthocone --defaults' lists all of them");
  }
  catch (const dealii::ExceptionBase &exception)
  {
    std::smatch match;
    const std::string reason = sentence(exception);
    const bool is_pattern = std::regex_search(reason, match, std::regex("given pattern <(.*)>\\."));
    throw InputError(place + " = " + value + ": allowed is " + (is_pattern ? match[1].str() : reason));
  }
  handler.leave_subsection();
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
  try
  {
    check_parameters(parameters);
  }
  catch (const InputError &error)
  {
    throw InputError(file_name + ": " + error.what());
  }
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
    throw InputError("Mesh/Quadrature points = " + std::to_string(mesh.quadrature_points) + ": with Mesh/Degree = " +
                     std::to_string(mesh.degree) + " allowed is 0 or more than the degree (fewer points leave " +
                     "deformations without stiffness)");
  const LoadOptions &load = parameters.load;
  if (load.preload.empty() && (load.legs.empty() || load.cycles == 0))
    throw InputError("Load program/Legs is empty, and so is the preload: allowed is at least one leg, such as "
                     "'0 0 -0.1 : 5'");
  for (const Probe &probe : parameters.output.probes)
    if (std::hypot(probe.position[0], probe.position[1]) > parameters.geometry.radius)
      throw InputError("Output/Probes: '" + probe.name + "' at (" + to_text(probe.position[0]) + ", " +
                       to_text(probe.position[1]) + ") is off the contact surface: allowed are points within " +
                       "Geometry/Radius = " + to_text(parameters.geometry.radius) + " of the axis");
}
} // namespace orthocone
