// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/text.h>

#include <algorithm>
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

constexpr std::size_t most_bytes = 200; // a few lines of a terminal

/// The first bytes of `text`, at most `most`, which do not end within a UTF-8 character.
std::string beginning(const std::string &text, const std::size_t most)
{
  constexpr std::size_t longest_character = 4;
  std::size_t size = most;
  while (size + longest_character > most && continues_character(text[size]))
    --size;
  return text.substr(0, size);
}

/// Bytes of the UTF-8 character at `place`; 0 if there is none.
std::size_t character_size(const std::string &text, const std::size_t place)
{
  const auto first = static_cast<unsigned char>(text[place]);
  const std::size_t size = first < 0x80                    ? 1
                           : first >= 0xc2 && first < 0xe0 ? 2
                           : first >= 0xe0 && first < 0xf0 ? 3
                           : first >= 0xf0 && first < 0xf5 ? 4
                                                           : 0;
  for (std::size_t i = 1; i < size; ++i)
    if (place + i >= text.size() || !continues_character(text[place + i]))
      return 0;
  return size;
}

/// Characters that move the cursor, or turn the direction of what follows.
bool is_control(const std::string &character)
{
  const auto byte = [&](const std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1)
    return byte(0) < 0x20 || byte(0) == 0x7f;
  if (character.size() == 2)
    return byte(0) == 0xc2 && byte(1) < 0xa0;
  const bool is_mark =
      byte(0) == 0xe2 && byte(1) == 0x80 && (byte(2) == 0x8e || byte(2) == 0x8f || byte(2) >= 0xa8);
  const bool turns = byte(0) == 0xe2 && byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9;
  return character.size() == 3 && ((is_mark && byte(2) <= 0xae) || turns);
}

/// Escapes as in C and JSON.
std::string escape(const std::string &bytes)
{
  constexpr const char *digits = "0123456789abcdef";
  if (bytes == "\n" || bytes == "\t" || bytes == "\r")
    return bytes == "\n" ? "\\n" : bytes == "\t" ? "\\t" : "\\r";
  std::string result;
  for (const char byte : bytes)
    result += {'\\', 'x', digits[static_cast<unsigned char>(byte) / 16],
               digits[static_cast<unsigned char>(byte) % 16]};
  return result;
}

std::string escaped(const std::string &text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t size = character_size(text, i);
    const std::string character = text.substr(i, std::max<std::size_t>(size, 1));
    result += size == 0 || is_control(character) ? escape(character) : character;
    i += character.size();
  }
  return result;
}

/// The last bytes of `text`, at most `most`, which do not begin within a UTF-8 character.
std::string ending(const std::string &text, const std::size_t most)
{
  std::size_t first = text.size() - most;
  while (first < text.size() && continues_character(text[first]))
    ++first;
  return text.substr(first);
}

/// A line of a message, without its middle where it is too long.
std::string fitted_line(const std::string &line)
{
  constexpr std::size_t most = 600, most_behind = 250;
  constexpr const char *gap = " [...] ";
  const std::string text = escaped(line);
  const std::size_t most_before = most - most_behind - std::string(gap).size();
  return text.size() <= most ? text : beginning(text, most_before) + gap + ending(text, most_behind);
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

std::string shown(const std::string &text)
{
  return text.size() <= most_bytes ? escaped(text) : escaped(beginning(text, most_bytes)) + "...";
}

std::string shown_path(const std::string &path)
{
  return path.size() <= most_bytes ? escaped(path) : "..." + escaped(ending(path, most_bytes));
}

std::string shown_message(const std::string &text)
{
  std::istringstream stream(text);
  std::string shown;
  for (std::string line; std::getline(stream, line);)
    shown += (shown.empty() ? "" : "\n") + fitted_line(line);
  return shown;
}
} // namespace orthocone
