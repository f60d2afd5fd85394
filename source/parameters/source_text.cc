// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "source_text.h"

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
constexpr unsigned int deepest_include = 20;

/// What stands behind `keyword` on this line, or "".
std::string behind_keyword(const std::string &line, const std::string &keyword)
{
  const std::string text = trimmed(line.substr(0, line.find('#')));
  if (text.compare(0, keyword.size() + 1, keyword + " ") != 0)
    return {};
  return trimmed(text.substr(keyword.size()));
}

bool is_text(const std::string &content)
{
  return std::none_of(content.begin(), content.end(),
                      [](const unsigned char c)
                      { return (c < 32 && c != '\t' && c != '\n' && c != '\r') || c == 127; });
}
} // namespace

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
  if (trimmed(content.str()).empty())
    throw InputError(asked_from + file_name +
                     ": is empty; 'orthocone --defaults' prints a complete parameter file to start from");
  if (!is_text(content.str()))
    throw InputError(asked_from + file_name +
                     ": is not a text file; a parameter file (.prm or .json) is wanted");
  return content.str();
}

SourceText::SourceText(const std::string &file_name)
{
  append(file_name, "", 0);
}

void SourceText::append(const std::string &file_name, const std::string &asked_from, const unsigned int depth)
{
  if (depth > deepest_include)
    throw InputError(asked_from + file_name + ": includes are nested more than " +
                     std::to_string(deepest_include) + " deep; does the file include itself?");
  std::istringstream stream(read_text_file(file_name, asked_from));
  SourceLine line{"", file_name, 0};
  while (std::getline(stream, line.text))
  {
    ++line.number;
    const std::string included = behind_keyword(line.text, "include");
    if (included.empty())
      lines_.push_back(line);
    else
      append((std::filesystem::path(file_name).parent_path() / included).string(), line.place() + ": ",
             depth + 1);
  }
}

std::string SourceText::joined() const
{
  std::string text;
  for (const SourceLine &line : lines_)
    text += line.text + "\n";
  return text;
}

bool SourceText::sets_anything() const
{
  return std::any_of(lines_.begin(), lines_.end(),
                     [](const SourceLine &source) { return !behind_keyword(source.text, "set").empty(); });
}

std::vector<unsigned int> SourceText::open_sections(const unsigned int number) const
{
  std::vector<unsigned int> open;
  for (unsigned int i = 1; i < number && i <= n_lines(); ++i)
    if (!behind_keyword(line(i).text, "subsection").empty())
      open.push_back(i);
    else if (trimmed(line(i).text) == "end" && !open.empty())
      open.pop_back();
  return open;
}

std::string SourceText::path_at(const unsigned int number) const
{
  std::string path;
  for (const unsigned int opening : open_sections(number))
    path += behind_keyword(line(opening).text, "subsection") + "/";
  return path;
}
} // namespace orthocone
