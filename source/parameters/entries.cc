// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "entries.h"

namespace orthocone::entries
{
namespace
{
std::string legs_text(const std::vector<Leg> &legs)
{
  std::string text;
  for (const Leg &leg : legs)
  {
    text += text.empty() ? "" : "; ";
    for (const double coordinate : leg.target)
      text += to_text(coordinate) + " ";
    text += ": " + std::to_string(leg.steps);
  }
  return text;
}

std::string probes_text(const std::vector<Probe> &probes)
{
  std::string text;
  for (const Probe &probe : probes)
    text += (text.empty() ? "" : "; ") + probe.name + ": " + to_text(probe.position[0]) + " " +
            to_text(probe.position[1]);
  return text;
}
} // namespace

bool Range::contains(const double value) const
{
  return (value > lower || (includes_lower && value == lower)) &&
         (value < upper || (includes_upper && value == upper));
}

std::string Range::describe() const
{
  std::string text;
  if (lower > any_number.lower)
    text += (includes_lower ? " >= " : " > ") + to_text(lower);
  if (upper < any_number.upper)
    text += std::string(text.empty() ? "" : " and") + (includes_upper ? " <= " : " < ") + to_text(upper);
  return text;
}

void add_entry(dealii::ParameterHandler &handler, const std::string &name, const std::string &default_text,
               const Allowed &allowed, const std::string &help,
               const std::function<void(const std::string &)> &assign)
{
  handler.declare_entry(name, default_text, allowed, help + " Allowed: " + allowed.description() + ".");
  handler.add_action(name, assign);
}

void add_number(dealii::ParameterHandler &handler, const std::string &name, double &value, const Range &range,
                const std::string &help)
{
  const auto test = [range](const std::string &text)
  {
    const auto number = parse_number(text);
    return number && range.contains(*number);
  };
  add_entry(handler, name, to_text(value), Allowed("a number" + range.describe(), test), help,
            [&value](const std::string &text) { value = *parse_number(text); });
}

void add_percentage(dealii::ParameterHandler &handler, const std::string &name, double &value,
                    const Range &range, const std::string &help)
{
  const auto test = [range](const std::string &text)
  {
    const auto number = parse_percentage(text);
    return number && (*number == 0 || range.contains(*number));
  };
  add_entry(handler, name, value == 0 ? "0" : to_text(value) + " %",
            Allowed("0, or a percentage" + range.describe() + " such as 1 %", test), help,
            [&value](const std::string &text) { value = *parse_percentage(text); });
}

void add_pair(dealii::ParameterHandler &handler, const std::string &name, std::array<double, 2> &value,
              const Range &range, const std::string &help)
{
  const auto test = [range](const std::string &text)
  {
    const auto pair = parse_numbers(text, 2, ',');
    return pair && range.contains((*pair)[0]) && range.contains((*pair)[1]);
  };
  add_entry(handler, name, to_text(value[0]) + ", " + to_text(value[1]),
            Allowed("two numbers" + range.describe() + " separated by a comma", test), help,
            [&value](const std::string &text)
            {
              const auto pair = *parse_numbers(text, 2, ',');
              value = {{pair[0], pair[1]}};
            });
}

void add_count(dealii::ParameterHandler &handler, const std::string &name, unsigned int &value,
               const unsigned int lower, const unsigned int upper, const std::string &help)
{
  const auto test = [lower, upper](const std::string &text)
  {
    const auto count = parse_count(text);
    return count && *count >= lower && *count <= upper;
  };
  const std::string allowed = "a whole number from " + std::to_string(lower) + " to " + std::to_string(upper);
  add_entry(handler, name, std::to_string(value), Allowed(allowed, test), help,
            [&value](const std::string &text) { value = *parse_count(text); });
}

void add_legs(dealii::ParameterHandler &handler, const std::string &name, std::vector<Leg> &value,
              const std::string &help)
{
  add_entry(handler, name, legs_text(value),
            Allowed("legs \"ux uy uz : steps\" (numbers in mm, at least one step), separated by ';'",
                    [](const std::string &text) { return parse_legs(text).has_value(); }),
            help, [&value](const std::string &text) { value = *parse_legs(text); });
}

void add_probes(dealii::ParameterHandler &handler, const std::string &name, std::vector<Probe> &value,
                const std::string &help)
{
  add_entry(handler, name, probes_text(value),
            Allowed("probes \"name: x y\" (numbers in mm; name of up to 100 letters, digits, '-', '_', used "
                    "once), separated "
                    "by ';'",
                    [](const std::string &text) { return parse_probes(text).has_value(); }),
            help, [&value](const std::string &text) { value = *parse_probes(text); });
}
} // namespace orthocone::entries
