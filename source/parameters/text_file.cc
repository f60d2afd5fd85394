// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "text_file.h"

#include <orthocone/parameters/errors.h>
#include <orthocone/parameters/text.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace orthocone
{
namespace
{
std::string without_byte_order_mark(const std::string &content)
{
  constexpr const char *mark = "\xef\xbb\xbf";
  return content.compare(0, std::strlen(mark), mark) == 0 ? content.substr(std::strlen(mark)) : content;
}

/// Lines may end in "\r\n" (Windows) or "\r" (old Macs).
std::string with_plain_line_ends(const std::string &content)
{
  std::string text;
  text.reserve(content.size());
  for (std::size_t i = 0; i < content.size(); ++i)
    if (content[i] != '\r')
      text += content[i];
    else if (i + 1 == content.size() || content[i + 1] != '\n')
      text += '\n';
  return text;
}

bool is_text(const std::string &content)
{
  return std::none_of(content.begin(), content.end(),
                      [](const unsigned char c) { return (c < 32 && c != '\t' && c != '\n') || c == 127; });
}
} // namespace

bool continues_character(const char c)
{
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

std::string read_text_file(const std::string &file_name, const std::string &asked_from)
{
  std::error_code code;
  if (std::filesystem::is_directory(file_name, code))
    throw FileError(asked_from + file_name + ": is a folder; a parameter file (.prm or .json) is wanted");
  std::ifstream stream(file_name, std::ios::binary);
  if (!stream)
    throw FileError(asked_from + file_name + ": cannot be read (" + std::strerror(errno) + ")");
  std::ostringstream content;
  content << stream.rdbuf();
  std::string text = with_plain_line_ends(without_byte_order_mark(content.str()));
  if (trimmed(text).empty())
    throw InputError(asked_from + file_name +
                     ": is empty; 'orthocone --defaults' prints a complete parameter file to start from");
  if (!is_text(text))
    throw InputError(asked_from + file_name +
                     ": is not a text file; a parameter file (.prm or .json) is wanted");
  return text;
}
} // namespace orthocone
