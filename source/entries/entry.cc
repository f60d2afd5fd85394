// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/entry.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/units.h>
#include <orthocone/entries/names.h>

#include <filesystem>

namespace orthocone
{
std::string Entry::why_ignored() const
{
  for (const Condition &condition : conditions_)
    if (!condition.holds())
      return condition.otherwise();
  return {};
}

void Entry::set(const std::string &text, const std::string &place, const std::string &file)
{
  std::string instead = binding_.allowed;
  if (!binding_.assign(without_units(text, unit_), instead))
    throw InputError(place + name_ + (text.empty() ? " is empty" : " = " + shown(text)) + remark(text) +
                     ": allowed is " + instead + fault_of_units(text, unit_));
  if (path_ != nullptr)
    *path_ = path_beside(file, text);
}

std::string path_beside(const std::string &file_name, const std::string &path)
{
  namespace fs = std::filesystem;
  return path.empty() ? ""
                      : fs::absolute(fs::path(file_name).parent_path() / path).lexically_normal().string();
}

Entry *EntryList::find(const std::string &name)
{
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry &entry) { return entry.name() == name; });
  return found == entries_.end() ? nullptr : &*found;
}

const Entry *EntryList::find(const std::string &name) const
{
  return const_cast<EntryList *>(this)->find(name);
}

bool EntryList::has_section(const std::string &name) const
{
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Entry &entry) { return entry.section() == name; });
}

bool EntryList::is_path(const std::string &name) const
{
  const Entry *const entry = find(name);
  return entry != nullptr && entry->is_path();
}

std::vector<std::string> EntryList::names() const
{
  std::vector<std::string> names;
  for (const Entry &entry : entries_)
    names.push_back(entry.name());
  return names;
}

std::vector<std::string> EntryList::sections() const
{
  std::vector<std::string> names;
  for (const Entry &entry : entries_)
    if (names.empty() || names.back() != entry.section())
      names.push_back(entry.section());
  return names;
}

std::vector<std::pair<std::string, std::string>> EntryList::values() const
{
  std::vector<std::pair<std::string, std::string>> values;
  for (const Entry &entry : entries_)
    values.emplace_back(entry.name(), entry.text());
  return values;
}

Entry &Section::add(const std::string &name, Entry::Binding binding, const std::string &help)
{
  list_.entries_.emplace_back(name_ + "/" + name, std::move(binding), help);
  Entry &entry = list_.entries_.back();
  return condition_ ? entry.only_if(*condition_) : entry;
}

std::vector<std::string> ignored_entries(const EntryList &list, const EntryList &defaults)
{
  std::vector<std::string> ignored;
  for (std::size_t i = 0; i < list.entries().size(); ++i)
  {
    const Entry &entry = list.entries()[i];
    const std::string why = entry.why_ignored();
    if (!why.empty() && entry.text() != defaults.entries()[i].text())
      ignored.push_back(entry.name() + " = " + shown(entry.text()) + " is ignored with " + why);
  }
  return ignored;
}
} // namespace orthocone
