// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "statements.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/entries/names.h>
#include <orthocone/entries/text_file.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <utility>

namespace orthocone
{
namespace
{
namespace fs = std::filesystem;

/// A line without its comment, joined with the lines that continue it.
struct Line
{
  std::string text;
  std::string place; ///< "file:line" of the first of them
  std::string raw;   ///< all of them as written
};

bool continues(const std::string &text)
{
  return !text.empty() && text.back() == '\\';
}

/// The content of a line of the file, without comment and backslash.
std::string content_of(const std::string &text, const std::string &place)
{
  const auto comment = text.find('#');
  if (!continues(text))
    return trimmed(text.substr(0, comment));
  if (comment == std::string::npos)
    return trimmed(text.substr(0, text.size() - 1));
  throw InputError(place + ": '" + shown(text) +
                   "' ends in a backslash, which would make a comment of the next line as well");
}

std::vector<Line> lines_of(const std::string &content, const std::string &file_name)
{
  std::vector<Line> lines;
  std::istringstream stream(content);
  bool is_continued = false;
  unsigned int number = 0;
  for (std::string text; std::getline(stream, text);)
  {
    const std::string place = shown_path(file_name) + ":" + std::to_string(++number);
    const std::string raw = text + "\n";
    std::replace(text.begin(), text.end(), '\t', ' ');
    text = trimmed(text);
    if (!is_continued)
      lines.push_back({"", place, ""});
    lines.back().raw += raw;
    // A blank is put between them: "0 0 1\" and "0 : 5" must not become "0 0 10 : 5".
    lines.back().text = trimmed(lines.back().text + (is_continued ? " " : "") + content_of(text, place));
    is_continued = continues(text);
  }
  return lines;
}

/// The text behind `keyword`, or "" if the line does not begin with it.
std::string behind(const std::string &keyword, const std::string &text)
{
  return text.compare(0, keyword.size() + 1, keyword + " ") == 0 ? trimmed(text.substr(keyword.size())) : "";
}

std::optional<Statement> parse(const Line &line, const std::string &file)
{
  using Kind = Statement::Kind;
  if (line.text == "end")
    return Statement{Kind::end, line.place, file};
  if (const std::string name = behind("subsection", line.text); !name.empty())
    return Statement{Kind::subsection, line.place, file, name};
  const std::string setting = behind("set", line.text);
  const auto equals = setting.find('=');
  const std::string name = trimmed(setting.substr(0, equals));
  if (name.empty() || equals == std::string::npos)
    return std::nullopt;
  return Statement{Kind::set, line.place, file, name, trimmed(setting.substr(equals + 1))};
}

/// Path of an included file for reading and for messages: without detours, unless these pass a symbolic link.
std::string included_path(const std::string &including, const std::string &included)
{
  const fs::path path = fs::path(including).parent_path() / included;
  const fs::path direct = path.lexically_normal();
  std::error_code code;
  return (fs::equivalent(path, direct, code) ? direct : path).string();
}

class Reader
{
public:
  explicit Reader(const EntryList &list)
      : list_(list)
  {
  }

  void read(const std::string &file_name, const std::string &asked_from);

  StatementFile result;

private:
  void check_include(const std::string &file_name, const std::string &asked_from);
  void include(const std::string &file_name, const Line &line);
  std::string text_for_any_folder(const Line &line, const Statement &statement);

  const EntryList &list_;
  std::string section_; ///< that is open
  std::vector<std::string> open_files_;
  unsigned int n_files_ = 0;
};

void Reader::check_include(const std::string &file_name, const std::string &asked_from)
{
  constexpr std::size_t most_nested = 20, longest = 16000000;
  constexpr unsigned int most = 1000;
  const std::string name = asked_from + shown_path(file_name);
  std::error_code code;
  for (const std::string &open : open_files_)
    if (fs::equivalent(open, file_name, code))
      throw InputError(name + ": is included by itself");
  if (open_files_.size() > most_nested)
    throw InputError(name + ": includes are nested more than " + std::to_string(most_nested) + " deep");
  if (++n_files_ > most || result.text.size() > longest)
    throw InputError(name + ": is one include too many: allowed are " + std::to_string(most) +
                     " with 16 MB in all");
}

void Reader::include(const std::string &file_name, const Line &line)
{
  const std::string name = included_path(file_name, behind("include", line.text));
  result.text += "# begin of " + shown_path(name) + "\n";
  read(name, line.place + ": ");
  result.text += "# end of " + shown_path(name) + "\n";
}

/// The line for a copy of the file in any folder: with the whole path where the entry names a file.
std::string Reader::text_for_any_folder(const Line &line, const Statement &statement)
{
  if (statement.kind == Statement::Kind::subsection)
    section_ = statement.name;
  if (statement.kind != Statement::Kind::set || !list_.is_path(section_ + "/" + statement.name) ||
      fs::path(statement.value).is_absolute())
    return line.raw;
  return "  set " + statement.name + " = " + path_beside(statement.file, statement.value) + "\n";
}

void Reader::read(const std::string &file_name, const std::string &asked_from)
{
  check_include(file_name, asked_from);
  open_files_.push_back(file_name);
  for (const Line &line : lines_of(with_plain_lines(read_text_file(file_name, asked_from)), file_name))
    if (!behind("include", line.text).empty())
      include(file_name, line);
    else
    {
      const auto statement = parse(line, file_name);
      result.text += statement ? text_for_any_folder(line, *statement) : line.raw;
      if (statement)
        result.statements.push_back(*statement);
      else if (!line.text.empty())
        throw InputError(line.place + ": '" + shown(line.text) + "'" + remark(line.text) +
                         " is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', "
                         "'include FILE' or '# comment'");
    }
  open_files_.pop_back();
}
} // namespace

StatementFile read_statements(const std::string &file_name, const EntryList &list)
{
  Reader reader(list);
  reader.read(file_name, "");
  return std::move(reader.result);
}
} // namespace orthocone
