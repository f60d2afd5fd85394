// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/values.h>

#include <orthocone/base/text.h>

#include <algorithm>
#include <set>

namespace orthocone
{
namespace
{
bool is_file_name(const std::string &name)
{
  constexpr std::size_t longest = 100; // file systems allow 255, including what is added in front and behind
  return !name.empty() && name.size() <= longest &&
         std::all_of(name.begin(), name.end(),
                     [](const unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

std::optional<Probe> parse_probe(const std::string &text)
{
  const auto parts = split(text, ':');
  if (parts.size() != 2 || !is_file_name(parts[0]))
    return std::nullopt;
  const auto position = parse_numbers(parts[1], 2, ' ');
  return position ? std::optional<Probe>({parts[0], {{(*position)[0], (*position)[1]}}}) : std::nullopt;
}
} // namespace

std::optional<std::vector<Probe>> parse_probes(const std::string &text)
{
  std::vector<Probe> probes;
  if (trimmed(text).empty())
    return probes;
  std::set<std::string> names;
  for (const auto &piece : split(text, ';'))
  {
    const auto probe = parse_probe(piece);
    if (!probe || !names.insert(probe->name).second)
      return std::nullopt;
    probes.push_back(*probe);
  }
  return probes;
}
} // namespace orthocone
