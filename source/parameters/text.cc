// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace orthocone
{
namespace
{
const char *const white_space = " \t\r\n";

std::vector<std::string> words_of(const std::string &text)
{
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

bool is_file_name(const std::string &name)
{
  constexpr std::size_t longest = 100; // file systems allow 255 with all that is put before and behind
  return !name.empty() && name.size() <= longest &&
         std::all_of(name.begin(), name.end(),
                     [](const unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

std::optional<Leg> parse_leg(const std::string &text)
{
  const auto parts = split(text, ':');
  if (parts.size() != 2)
    return std::nullopt;
  const auto target = parse_numbers(parts[0], 3, ' ');
  const auto steps = parse_count(parts[1]);
  if (!target || !steps || *steps == 0)
    return std::nullopt;
  return Leg{{{(*target)[0], (*target)[1], (*target)[2]}}, *steps};
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

std::string to_text(const double value)
{
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), result.ptr);
}

std::string trimmed(const std::string &text)
{
  const auto first = text.find_first_not_of(white_space);
  if (first == std::string::npos)
    return {};
  return text.substr(first, text.find_last_not_of(white_space) - first + 1);
}

std::vector<std::string> split(const std::string &text, const char separator)
{
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, separator);)
    pieces.push_back(trimmed(piece));
  return pieces;
}

std::optional<double> parse_number(const std::string &text)
{
  double value = 0;
  const bool has_plus = text.size() > 1 && text.front() == '+' && text[1] != '-';
  const char *const begin = text.data() + (has_plus ? 1 : 0);
  const char *const end = text.data() + text.size();
  const auto result = std::from_chars(begin, end, value);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<unsigned int> parse_count(const std::string &text)
{
  unsigned int value = 0;
  const char *const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end)
    return std::nullopt;
  return value;
}

std::optional<double> parse_percentage(const std::string &text)
{
  if (text == "0")
    return 0;
  return !text.empty() && text.back() == '%' ? parse_number(trimmed(text.substr(0, text.size() - 1)))
                                             : std::nullopt;
}

std::optional<std::vector<double>> parse_numbers(const std::string &text, const unsigned int n,
                                                 const char separator)
{
  const auto pieces = separator == ' ' ? words_of(text) : split(text, separator);
  const bool ends_early = !text.empty() && text.back() == separator && separator != ' ';
  if (pieces.size() != n || ends_early)
    return std::nullopt;
  std::vector<double> numbers;
  for (const auto &piece : pieces)
    if (const auto number = parse_number(piece))
      numbers.push_back(*number);
    else
      return std::nullopt;
  return numbers;
}

std::optional<std::vector<Leg>> parse_legs(const std::string &text)
{
  std::vector<Leg> legs;
  if (trimmed(text).empty())
    return legs;
  for (const auto &piece : split(text, ';'))
    if (const auto leg = parse_leg(piece))
      legs.push_back(*leg);
    else
      return std::nullopt;
  return legs;
}

std::optional<std::vector<Probe>> parse_probes(const std::string &text)
{
  std::vector<Probe> probes;
  if (trimmed(text).empty())
    return probes;
  for (const auto &piece : split(text, ';'))
  {
    const auto probe = parse_probe(piece);
    const auto has_its_name = [&](const Probe &other) { return other.name == probe->name; };
    if (!probe || std::any_of(probes.begin(), probes.end(), has_its_name))
      return std::nullopt;
    probes.push_back(*probe);
  }
  return probes;
}
} // namespace orthocone
