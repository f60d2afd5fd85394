// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "entries.h"

#include <algorithm>

namespace orthocone::entries
{
namespace
{
/// Whether a name has no character that separates names or begins a comment.
bool is_group(const std::string &text)
{
  return std::none_of(text.begin(), text.end(),
                      [](const unsigned char c) { return c < ' ' || std::string("#\\,;:").find(c) < 5; });
}

std::vector<std::string> parse_groups(const std::string &text)
{
  return text.empty() ? std::vector<std::string>() : split(text, ',');
}

std::string triple_text(const std::array<double, 3> &value)
{
  return to_text(value[0]) + ", " + to_text(value[1]) + ", " + to_text(value[2]);
}

std::optional<MaterialRegion> parse_region(const std::string &text)
{
  const Range poisson{-1, 0.5};
  const auto parts = split(text, ':');
  if (parts.size() != 2 || parts[0].empty() || !is_group(parts[0]))
    return std::nullopt;
  const auto constants = parse_numbers(parts[1], 2, ',');
  if (!constants || !positive.contains((*constants)[0]) || !poisson.contains((*constants)[1]))
    return std::nullopt;
  return MaterialRegion{parts[0], (*constants)[0], (*constants)[1]};
}

/// Reads regions. Returns nothing if the text is malformed, or if it names a volume twice.
std::optional<std::vector<MaterialRegion>> parse_regions(const std::string &text)
{
  std::vector<MaterialRegion> regions;
  if (text.empty())
    return regions;
  for (const std::string &part : split(text, ';'))
  {
    const auto region = parse_region(part);
    const auto is_same = [&](const MaterialRegion &other) { return other.volume == region->volume; };
    if (!region || std::any_of(regions.begin(), regions.end(), is_same))
      return std::nullopt;
    regions.push_back(*region);
  }
  return regions;
}
} // namespace

void add_triple(EntryTable &table, const std::string &name, std::array<double, 3> &value,
                const std::string &help)
{
  const auto is_triple = [](const std::string &text) { return parse_numbers(text, 3, ',').has_value(); };
  table.add(name, triple_text(value), Allowed("three numbers separated by commas", is_triple), help,
            [&value](const std::string &text)
            {
              const auto numbers = *parse_numbers(text, 3, ',');
              std::copy(numbers.begin(), numbers.end(), value.begin());
            });
}

void add_group(EntryTable &table, const std::string &name, std::string &value, const std::string &help)
{
  table.add(name, value,
            Allowed("a name without '#', '\\', ',', ';' and ':', a number, or nothing", is_group), help,
            [&value](const std::string &text) { value = text; });
}

void add_groups(EntryTable &table, const std::string &name, std::vector<std::string> &value,
                const std::string &help)
{
  std::string given;
  for (const std::string &group : value)
    given += (given.empty() ? "" : ", ") + group;
  const auto are_groups = [](const std::string &text)
  {
    const auto groups = parse_groups(text);
    return std::all_of(groups.begin(), groups.end(),
                       [](const std::string &group) { return !group.empty() && is_group(group); });
  };
  table.add(name, given, Allowed("names or numbers separated by commas, or nothing", are_groups), help,
            [&value](const std::string &text) { value = parse_groups(text); });
}

std::string regions_text(const std::vector<MaterialRegion> &regions)
{
  std::string text;
  for (const MaterialRegion &region : regions)
    text += (text.empty() ? "" : " ; ") + region.volume + ": " + to_text(region.young_modulus) + ", " +
            to_text(region.poisson_ratio);
  return text;
}

void add_regions(EntryTable &table, const std::string &name, std::vector<MaterialRegion> &value,
                 const std::string &help)
{
  table.add(
      name, regions_text(value),
      Allowed("nothing, or regions \"name: E, nu\" (E > 0 in MPa, nu > -1 and < 0.5; each volume once), "
              "separated by ';'",
              [](const std::string &text) { return parse_regions(text).has_value(); }),
      help, [&value](const std::string &text) { value = *parse_regions(text); });
}
} // namespace orthocone::entries
