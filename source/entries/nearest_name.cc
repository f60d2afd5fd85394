// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/names.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <sstream>

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

/// The part behind the last '/'.
std::string own_part(const std::string &name)
{
  return name.substr(name.rfind('/') + 1);
}

/// The part before the last '/', or "".
std::string section_of(const std::string &name)
{
  return name.substr(0, name.size() - own_part(name).size());
}

/// How many letters must be inserted, deleted, exchanged or swapped with their neighbour to turn `b` into `a`
/// (the restricted Damerau-Levenshtein distance).
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

/// How many letters of a name may be wrong: with more, the nearest name is hardly the one that was meant.
std::size_t tolerance(const std::string &name)
{
  return std::min(name.size() / 2, std::max<std::size_t>(2, name.size() / 3));
}

std::string nearest_in_letters(const std::string &name, const std::vector<std::string> &candidates)
{
  const std::string own = own_part(name);
  const std::size_t most = tolerance(own);
  std::size_t least = most + 2;
  std::string nearest;
  for (const std::string &candidate : candidates)
  {
    const std::size_t d = distance(own, own_part(candidate));
    // An entry with only its section wrong counts as one wrong letter.
    const std::size_t all = d + (section_of(name) == section_of(candidate) ? 0 : 1);
    if (d <= most && all < least)
    {
      least = all;
      nearest = candidate;
    }
  }
  return nearest;
}

std::set<std::string> words_of(const std::string &name)
{
  std::istringstream stream(name);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// Searches the same section, or all of them if `name` has none.
std::string nearest_in_words(const std::string &name, const std::vector<std::string> &candidates)
{
  const auto words = words_of(own_part(name));
  const auto has_these = [&](const std::string &candidate)
  {
    const auto others = words_of(own_part(candidate));
    return (section_of(name).empty() || section_of(name) == section_of(candidate)) && !words.empty() &&
           (std::includes(others.begin(), others.end(), words.begin(), words.end()) ||
            std::includes(words.begin(), words.end(), others.begin(), others.end()));
  };
  const auto found = std::find_if(candidates.begin(), candidates.end(), has_these);
  return found == candidates.end() ? "" : *found;
}
} // namespace

std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates)
{
  constexpr std::size_t longest = 100; // letters; the distance takes their square
  if (name.size() > longest)
    return {};
  std::vector<std::string> in_lower_case;
  std::transform(candidates.begin(), candidates.end(), std::back_inserter(in_lower_case), lower_case);
  const std::string text = lower_case(name);
  std::string nearest = nearest_in_letters(text, in_lower_case);
  if (nearest.empty())
    nearest = nearest_in_words(text, in_lower_case);
  const auto found = std::find(in_lower_case.begin(), in_lower_case.end(), nearest);
  return found == in_lower_case.end() ? "" : candidates[found - in_lower_case.begin()];
}
} // namespace orthocone
