// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/text.h>

#include <array>
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

bool continues_character(const char c)
{
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}
} // namespace orthocone
