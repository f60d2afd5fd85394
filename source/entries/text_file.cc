// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/text_file.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/input_file.h>
#include <orthocone/base/text.h>

#include <algorithm>
#include <cstring>

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

std::string content_of(const std::string &path, const std::string &name, const TextFileKind &kind)
{
  constexpr std::size_t megabyte = 1000000;
  InputFile file(path, name);
  if (file.is_folder())
    throw FileError(name + ": is a folder; " + kind.name + " is wanted");
  std::string content = file.read(kind.most_megabytes * megabyte + 1);
  if (content.size() > kind.most_megabytes * megabyte)
    throw InputError(name + ": is larger than " + std::to_string(kind.most_megabytes) + " MB; " + kind.name +
                     " is wanted");
  return content;
}

bool is_text(const std::string &content)
{
  return std::none_of(content.begin(), content.end(),
                      [](const unsigned char c) { return (c < 32 && c != '\t' && c != '\n') || c == 127; });
}
} // namespace

std::string read_text_file(const std::string &file_name, const std::string &asked_from,
                           const TextFileKind &kind)
{
  const std::string name = asked_from + shown_path(file_name);
  const std::string content = content_of(file_name, name, kind);
  const std::string text = with_plain_lines(content);
  if (trimmed(text).empty())
    throw InputError(name + ": is empty; " + kind.if_empty);
  if (!is_text(text))
    throw InputError(name + ": is not a text file; " + kind.name + " is wanted");
  return content;
}

std::string with_plain_lines(const std::string &content)
{
  return with_plain_line_ends(without_byte_order_mark(content));
}
} // namespace orthocone
