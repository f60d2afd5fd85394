// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "text_file.h"

#include <orthocone/parameters/text.h>

namespace orthocone
{
namespace
{
constexpr std::size_t most_bytes = 200;

/// The first bytes of `text`, at most `most`, without a part of a UTF-8 character at the end.
std::string beginning(const std::string &text, const std::size_t most)
{
  constexpr std::size_t longest_character = 4;
  std::size_t size = most;
  while (size + longest_character > most && continues_character(text[size]))
    --size;
  return text.substr(0, size);
}

bool is_control(const unsigned char c)
{
  constexpr unsigned char blank = 0x20, del = 0x7f;
  return c < blank || c == del;
}

/// A control character as in C and JSON, others as they are.
std::string printable(const unsigned char c)
{
  constexpr const char *digits = "0123456789abcdef";
  if (!is_control(c))
    return {static_cast<char>(c)};
  if (c == '\n' || c == '\t' || c == '\r')
    return c == '\n' ? "\\n" : c == '\t' ? "\\t" : "\\r";
  return {'\\', 'x', digits[c / 16], digits[c % 16]};
}

std::string escaped(const std::string &text)
{
  std::string result;
  for (const char c : text)
    result += printable(static_cast<unsigned char>(c));
  return result;
}

/// The last bytes of `text`, at most `most`, without a part of a UTF-8 character at the beginning.
std::string ending(const std::string &text, const std::size_t most)
{
  std::size_t first = text.size() - most;
  while (first < text.size() && continues_character(text[first]))
    ++first;
  return text.substr(first);
}
} // namespace

std::string shown(const std::string &text)
{
  return text.size() <= most_bytes ? escaped(text) : escaped(beginning(text, most_bytes)) + "...";
}

std::string shown_path(const std::string &path)
{
  return path.size() <= most_bytes ? escaped(path) : "..." + escaped(ending(path, most_bytes));
}
} // namespace orthocone
