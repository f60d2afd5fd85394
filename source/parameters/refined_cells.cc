// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "entries.h"

#include <sstream>

namespace orthocone::entries
{
namespace
{
using Rounds = std::vector<std::vector<CellRange>>;

std::string rounds_text(const Rounds &rounds)
{
  std::string text;
  for (std::size_t i = 0; i < rounds.size(); ++i)
  {
    text += i == 0 ? "" : "; ";
    for (std::size_t j = 0; j < rounds[i].size(); ++j)
    {
      const auto &[first, last] = rounds[i][j];
      text += (j == 0 ? "" : " ") + std::to_string(first) + (last == first ? "" : "-" + std::to_string(last));
    }
  }
  return text;
}

/// Reads a number, or two of them with a minus sign between.
std::optional<CellRange> parse_range(const std::string &text)
{
  const std::size_t minus = text.find('-');
  const auto first = parse_count(text.substr(0, minus));
  const auto last = minus == std::string::npos ? first : parse_count(text.substr(minus + 1));
  if (!first || !last || *last < *first)
    return std::nullopt;
  return CellRange{*first, *last};
}

std::optional<Rounds> parse_rounds(const std::string &text)
{
  Rounds rounds;
  if (text.empty())
    return rounds;
  for (const std::string &part : split(text, ';'))
  {
    rounds.emplace_back();
    std::istringstream words(part);
    for (std::string word; words >> word;)
    {
      const auto range = parse_range(word);
      if (!range)
        return std::nullopt;
      rounds.back().push_back(*range);
    }
    if (rounds.back().empty())
      return std::nullopt;
  }
  return rounds;
}
} // namespace

void add_refined_cells(EntryTable &table, const std::string &name, Rounds &value, const std::string &help)
{
  table.add(
      name, rounds_text(value),
      Allowed("nothing, or rounds, separated by ';', of the numbers of the mesh's cells, such as '0 4-7; "
              "12'",
              [](const std::string &text) { return parse_rounds(text).has_value(); }),
      help, [&value](const std::string &text) { value = *parse_rounds(text); });
}
} // namespace orthocone::entries
