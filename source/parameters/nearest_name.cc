// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "faults.h"

#include <algorithm>
#include <cctype>

namespace orthocone
{
namespace
{
std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](const unsigned char c) { return std::tolower(c); });
  return text;
}

/// What follows "Section/".
std::string entry_of(const std::string &name)
{
  return name.substr(name.find('/') + 1);
}

/// Letters to insert, delete, exchange or swap with their neighbour to make `a` of `b` (the restricted
/// Damerau-Levenshtein distance).
std::size_t distance(const std::string &a, const std::string &b)
{
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = row;
  }
  return last[b.size()];
}
} // namespace

std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates)
{
  constexpr std::size_t longest = 100;
  if (name.size() > longest)
    return {};
  // A third of the letters may be wrong; with more, the nearest name is hardly the one that was meant.
  std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
  std::string nearest;
  for (const std::string &candidate : candidates)
  {
    // An entry that is right but for its section counts as one wrong letter.
    const std::size_t d = std::min(distance(lower_case(name), lower_case(candidate)),
                                   distance(lower_case(entry_of(name)), lower_case(entry_of(candidate))) + 1);
    if (d < least)
    {
      least = d;
      nearest = candidate;
    }
  }
  return nearest;
}
} // namespace orthocone
