// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "entries.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace orthocone::entries
{
namespace
{
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

void add_sizes(EntryTable &table, const std::string &name, std::array<double, 3> &value,
               const std::string &help)
{
  const auto parse = [](const std::string &text)
  {
    auto sizes = parse_numbers(text, 3, ',');
    const auto is_positive = [](const double size) { return positive.contains(size); };
    if (sizes && !std::all_of(sizes->begin(), sizes->end(), is_positive))
      sizes.reset();
    return sizes;
  };
  table.add(name, to_text(value[0]) + ", " + to_text(value[1]) + ", " + to_text(value[2]),
            Allowed("three numbers > 0 separated by commas",
                    [parse](const std::string &text) { return parse(text).has_value(); }),
            help,
            [&value, parse](const std::string &text)
            {
              const auto sizes = *parse(text);
              std::copy(sizes.begin(), sizes.end(), value.begin());
            });
}

/// Three counts from 1 to `most`, or nothing.
static std::optional<std::array<unsigned int, 3>> parse_cells(const std::string &text,
                                                              const unsigned int most)
{
  const auto parts = split(text, ',');
  std::array<unsigned int, 3> cells{};
  if (parts.size() != cells.size())
    return std::nullopt;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const auto count = parse_count(parts[i]);
    if (!count || *count < 1 || *count > most)
      return std::nullopt;
    cells[i] = *count;
  }
  return cells;
}

void add_cells(EntryTable &table, const std::string &name, std::array<unsigned int, 3> &value,
               const unsigned int most, const std::string &help)
{
  table.add(name,
            std::to_string(value[0]) + ", " + std::to_string(value[1]) + ", " + std::to_string(value[2]),
            Allowed("three whole numbers from 1 to " + std::to_string(most) + " separated by commas",
                    [most](const std::string &text) { return parse_cells(text, most).has_value(); }),
            help, [&value, most](const std::string &text) { value = *parse_cells(text, most); });
}

void add_legs(EntryTable &table, const std::string &name, std::vector<Leg> &value, const std::string &help)
{
  table.add(name, legs_text(value),
            Allowed(
                allowed_legs(), [](const std::string &text) { return parse_legs(text).has_value(); },
                [](const std::string &text)
                {
                  std::string instead;
                  parse_legs(text, &instead);
                  return instead;
                }),
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
const Entry *EntryTable::find(const std::string &name) const
{
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry &entry) { return entry.name == name; });
  return found == entries_.end() ? nullptr : &*found;
}

bool EntryTable::is_path(const std::string &name) const
{
  const Entry *const entry = find(name);
  return entry != nullptr && entry->is_path;
}

std::string EntryTable::path_beside(const std::string &file_name, const std::string &path)
{
  namespace fs = std::filesystem;
  return path.empty() ? ""
                      : fs::absolute(fs::path(file_name).parent_path() / path).lexically_normal().string();
}
} // namespace orthocone
