// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "readers.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/json_walk.h>
#include <orthocone/base/text.h>
#include <orthocone/entries/names.h>
#include <orthocone/entries/text_file.h>

#include <set>
#include <utility>

namespace orthocone
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr const char *json_form = "{\"Section\": {\"Entry\": value}}";

constexpr unsigned int deepest = 10;

/// Checks the text before it is read, because the library's reader silently keeps the last of several values
/// with one name.
class JsonCheck : public JsonWalk<Json>
{
public:
  JsonCheck(std::string name, const std::string &text)
      : JsonWalk(deepest),
        name_(std::move(name)),
        text_(text)
  {
  }

  bool key(string_t &name) override;
  bool parse_error(std::size_t position, const std::string &, const nlohmann::detail::exception &) override;

private:
  /// An object or array, the names in it so far, and the last of them.
  struct Level
  {
    std::set<std::string> names;
    std::string last;
  };

  bool open() override;
  bool close() override;

  const std::string name_;
  const std::string &text_;
  std::vector<Level> levels_;
  unsigned int n_names_ = 0;
};

bool JsonCheck::open()
{
  levels_.emplace_back();
  if (!JsonWalk::open())
    throw InputError(name_ + ": is nested more than " + std::to_string(deepest) + " deep; allowed is " +
                     json_form);
  return true;
}

bool JsonCheck::close()
{
  levels_.pop_back();
  return JsonWalk::close();
}

bool JsonCheck::key(string_t &name)
{
  constexpr unsigned int most = 1000; // the library's tree searches all names for one
  if (++n_names_ > most)
    throw InputError(name_ + ": has more than " + std::to_string(most) + " names; allowed is " + json_form);
  const bool is_first = levels_.back().names.insert(name).second;
  levels_.back().last = name;
  if (is_first)
    return true;
  std::string path;
  for (const Level &level : levels_)
    if (!level.last.empty()) // arrays have no names
      path += (path.empty() ? "" : "/") + level.last;
  throw InputError(name_ + ": " + shown(path) + " is given twice");
}

/// `position` counts the bytes up to the one that does not fit, including it, which may be the end of the
/// text.
bool JsonCheck::parse_error(const std::size_t position, const std::string &,
                            const nlohmann::detail::exception &)
{
  unsigned int line = 1, column = 1;
  for (const char c : text_.substr(0, position - std::min<std::size_t>(position, 1)))
    if (c == '\n')
    {
      ++line;
      column = 1;
    }
    else if (!continues_character(c))
      ++column;
  throw InputError(name_ + ":" + std::to_string(line) + ": is not valid JSON at column " +
                   std::to_string(column) + "; allowed is " + json_form);
}

/// The fault of a value at the top that is not a section with entries.
std::string wrong_section(const std::string &name, const Json &value, const EntryList &list)
{
  const std::string given = shown(value.dump());
  const std::string fault = shown(name) + " = " + given + ": allowed is the form ";
  if (list.has_section(name))
    return fault + "{\"" + name + "\": {\"Entry\": value}}";
  if (const auto slash = name.find('/'); list.find(name) != nullptr)
    return fault + "{\"" + name.substr(0, slash) + "\": {\"" + name.substr(slash + 1) + "\": " + given + "}}";
  return not_a_section(name, list);
}

/// The text for a copy of the file in any folder: with the whole paths of files that entries name. A file
/// without such a path keeps its form.
std::string json_for_any_folder(const std::string &file_name, std::string content, Json json,
                                const EntryList &list)
{
  bool changes = false;
  for (auto &[section, entries] : json.items())
    for (auto &[entry, value] : entries.items()) // a text has itself as its only item, without a name
      if (list.is_path(section + "/" + entry) && value.is_string())
      {
        const std::string whole = path_beside(file_name, value.get<std::string>());
        changes = changes || whole != value;
        value = whole;
      }
  return changes ? json.dump(2) + "\n" : std::move(content);
}
} // namespace

std::string read_json(const std::string &file_name, EntryList &list)
{
  const std::string name = shown_path(file_name);
  const std::string place = name + ": ";
  std::string content = read_text_file(file_name);
  const std::string text = with_plain_lines(content);
  JsonCheck check(name, text);
  Json::sax_parse(text, &check);
  const Json json = Json::parse(text);
  if (!json.is_object())
    throw InputError(place + "is not valid JSON of the form " + json_form);
  const auto set = [&](const std::string &section, const std::string &entry, const Json &value)
  {
    set_entry(section + "/" + entry, value.is_string() ? value.get<std::string>() : value.dump(), place,
              file_name, list);
  };
  for (const auto &[section, entries] : json.items())
    for (const auto &[entry, value] : entries.items())
      if (const Entry *const known = list.find(section + "/" + entry); known && known->is_read_first())
        set(section, entry, value);
  bool sets_anything = false;
  for (const auto &[section, entries] : json.items())
  {
    if (section == "$schema" && entries.is_string()) // editors look for it there
      continue;
    if (!list.has_section(section) || !entries.is_object())
      throw InputError(place + wrong_section(section, entries, list));
    for (const auto &[entry, value] : entries.items())
      set(section, entry, value);
    sets_anything = sets_anything || !entries.empty();
  }
  if (!sets_anything)
    throw InputError(sets_no_entry(file_name));
  return json_for_any_folder(file_name, std::move(content), json, list);
}
} // namespace orthocone
