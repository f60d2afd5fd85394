// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "entries.h"

#include <cstdlib>

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

static std::string describe_range(const Range &range, const bool with_lower, const bool with_upper)
{
  std::string text;
  if (with_lower)
    text += (range.includes_lower ? " >= " : " > ") + to_text(range.lower);
  if (with_upper)
    text += std::string(text.empty() ? "" : " and") + (range.includes_upper ? " <= " : " < ") +
            to_text(range.upper);
  return text;
}

std::string Range::describe() const
{
  return describe_range(*this, lower > any_number.lower, upper < any_number.upper);
}

std::string Range::describe_for(const std::string &value) const
{
  const double number = std::strtod(value.c_str(), nullptr); // infinite for 1e999
  return describe_range(*this, lower > any_number.lower || number <= lower,
                        upper < any_number.upper || number >= upper);
}

void add_number(EntryTable &table, const std::string &name, double &value, const Range &range,
                const std::string &help)
{
  const auto test = [range](const std::string &text)
  {
    const auto number = parse_number(text);
    return number && range.contains(*number);
  };
  const Allowed allowed("a number" + range.describe(), test,
                        [range](const std::string &text) { return "a number" + range.describe_for(text); });
  table.add(name, to_text(value), allowed, help,
            [&value](const std::string &text) { value = *parse_number(text); });
}

void add_percentage(EntryTable &table, const std::string &name, double &value, const Range &range,
                    const std::string &help)
{
  const auto test = [range](const std::string &text)
  {
    const auto number = parse_percentage(text);
    return number && (*number == 0 || range.contains(*number));
  };
  table.add(name, value == 0 ? "0" : to_text(value) + " %",
            Allowed("0, or a percentage" + range.describe() + " such as 1 %", test), help,
            [&value](const std::string &text) { value = *parse_percentage(text); });
}

/// Two numbers separated by a comma, both within the range.
static std::optional<std::array<double, 2>> parse_pair(const std::string &text, const Range &range)
{
  const auto pair = parse_numbers(text, 2, ',');
  if (!pair || !range.contains((*pair)[0]) || !range.contains((*pair)[1]))
    return std::nullopt;
  return std::array<double, 2>{{(*pair)[0], (*pair)[1]}};
}

static std::string pair_text(const std::array<double, 2> &pair)
{
  return to_text(pair[0]) + ", " + to_text(pair[1]);
}

void add_coefficients(EntryTable &table, const std::string &name, std::array<double, 2> &value,
                      const std::string &help)
{
  const auto parse = [](const std::string &text) -> std::optional<std::array<double, 2>>
  {
    const auto pair = parse_pair(text, Range{0, positive.upper, true, false});
    const bool is_half_zero = pair && ((*pair)[0] == 0) != ((*pair)[1] == 0);
    return is_half_zero ? std::nullopt : pair;
  };
  table.add(name, pair_text(value),
            Allowed("two numbers > 0 (or both 0: no friction) separated by a comma",
                    [parse](const std::string &text) { return parse(text).has_value(); }),
            help, [&value, parse](const std::string &text) { value = *parse(text); });
}

void add_slip_potential(EntryTable &table, const std::string &name,
                        std::optional<std::array<double, 2>> &value, const std::string &help)
{
  constexpr const char *associated = "associated";
  table.add(name, value ? pair_text(*value) : associated,
            Allowed("associated, or two numbers > 0 separated by a comma",
                    [](const std::string &text) { return text == associated || parse_pair(text, positive); }),
            help, [&value](const std::string &text) { value = parse_pair(text, positive); });
}

void add_count(EntryTable &table, const std::string &name, unsigned int &value, const unsigned int lower,
               const unsigned int upper, const std::string &help)
{
  const auto test = [lower, upper](const std::string &text)
  {
    const auto count = parse_count(text);
    return count && *count >= lower && *count <= upper;
  };
  const std::string allowed = "a whole number from " + std::to_string(lower) + " to " + std::to_string(upper);
  table.add(name, std::to_string(value), Allowed(allowed, test), help,
            [&value](const std::string &text) { value = *parse_count(text); });
}

void add_legs(EntryTable &table, const std::string &name, std::vector<Leg> &value, const std::string &help)
{
  table.add(name, legs_text(value),
            Allowed("legs \"ux uy uz : steps\" (numbers in mm, at least one step), separated by ';'",
                    [](const std::string &text) { return parse_legs(text).has_value(); }),
            help, [&value](const std::string &text) { value = *parse_legs(text); });
}

void add_probes(EntryTable &table, const std::string &name, std::vector<Probe> &value,
                const std::string &help)
{
  table.add(name, probes_text(value),
            Allowed("probes \"name: x y\" (numbers in mm; name of up to 100 letters, digits, '-', '_', used "
                    "once), separated "
                    "by ';'",
                    [](const std::string &text) { return parse_probes(text).has_value(); }),
            help, [&value](const std::string &text) { value = *parse_probes(text); });
}
} // namespace orthocone::entries

namespace orthocone
{
void EntryTable::enter(const std::string &section)
{
  section_ = section;
}

void EntryTable::add(const std::string &name, const std::string &default_text, const Allowed &allowed,
                     const std::string &help, const std::function<void(const std::string &)> &assign)
{
  handler_.enter_subsection(section_);
  handler_.declare_entry(name, default_text, allowed, help + " Allowed: " + allowed.description() + ".");
  handler_.add_action(name, assign);
  handler_.leave_subsection();
  allowed_.emplace(section_ + "/" + name, allowed);
}

std::optional<std::string> EntryTable::what_is_allowed_instead(const std::string &name,
                                                               const std::string &value) const
{
  const Allowed &allowed = allowed_.at(name);
  return allowed.match(value) ? std::nullopt : std::optional<std::string>(allowed.description_for(value));
}

void EntryTable::set(const std::string &name, const std::string &value)
{
  const auto slash = name.find('/');
  handler_.enter_subsection(name.substr(0, slash));
  handler_.set(name.substr(slash + 1), value);
  handler_.leave_subsection();
}
} // namespace orthocone
