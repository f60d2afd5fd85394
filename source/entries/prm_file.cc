// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "readers.h"
#include "statements.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>
#include <orthocone/entries/names.h>

#include <algorithm>
#include <map>

namespace orthocone
{
namespace
{
std::string quoted(const Statement &subsection)
{
  return "'subsection " + shown(subsection.name) + "'";
}

/// Checks that no section has sections of its own; `open` is the section of the statement, or null.
void check_subsection(const Statement &statement, const Statement *const open, const EntryList &list)
{
  if (!open && !list.has_section(statement.name))
    throw InputError(statement.place + ": " + not_a_section(statement.name, list));
  if (open && list.has_section(statement.name))
    throw InputError(open->place + ": " + quoted(*open) + " has no 'end' before " + quoted(statement) + " (" +
                     statement.place + ")");
  if (open)
    throw InputError(statement.place + ": " + not_a_section(open->name + "/" + statement.name, list));
}

/// The settings of the open section, in which those that are given twice are found.
using Settings = std::map<std::string, const Statement *>;

/// An entry may be given again in another file, which overrides an included one, but not in the same file.
void check_repetition(const Statement &statement, const Settings &settings)
{
  const auto earlier = settings.find(statement.name);
  if (earlier != settings.end() && earlier->second->file == statement.file)
    throw InputError(statement.place + ": " + shown(statement.name) +
                     " is given twice in this section, before in " + earlier->second->place);
}

void set(const Statement &statement, const Statement *const open, EntryList &list)
{
  const std::string &name = statement.name;
  const std::string place = statement.place + ": ";
  if (const auto slash = name.find('/'); list.find(name) != nullptr)
    throw InputError(place + name + " is set within 'subsection " + name.substr(0, slash) + "', as 'set " +
                     name.substr(slash + 1) + " = " + shown(statement.value) + "'");
  set_entry((open ? open->name + "/" : "") + name, statement.value, place, statement.file, list);
}

/// Sets entries to which the texts of others refer. Faults of the form are found behind this.
void read_first(const std::vector<Statement> &statements, EntryList &list)
{
  std::string section;
  for (const Statement &statement : statements)
    if (statement.kind == Statement::Kind::subsection)
      section = statement.name;
    else if (const Entry *const entry = list.find(section + "/" + statement.name);
             statement.kind == Statement::Kind::set && entry != nullptr && entry->is_read_first())
      set_entry(entry->name(), statement.value, statement.place + ": ", statement.file, list);
}

void read_all(const std::vector<Statement> &statements, EntryList &list)
{
  read_first(statements, list);
  const Statement *open = nullptr;
  Settings settings;
  for (const Statement &statement : statements)
    switch (statement.kind)
    {
    case Statement::Kind::subsection:
      check_subsection(statement, open, list);
      open = &statement;
      settings.clear();
      break;
    case Statement::Kind::set:
      set(statement, open, list);
      check_repetition(statement, settings);
      settings[statement.name] = &statement;
      break;
    case Statement::Kind::end:
      if (!open)
        throw InputError(statement.place + ": 'end' has no 'subsection'");
      open = nullptr;
      break;
    }
  if (open)
    throw InputError(open->place + ": " + quoted(*open) + " has no 'end'");
}
} // namespace

std::string read_prm(const std::string &file_name, EntryList &list)
{
  const StatementFile file = read_statements(file_name, list);
  read_all(file.statements, list);
  if (std::none_of(file.statements.begin(), file.statements.end(),
                   [](const Statement &statement) { return statement.kind == Statement::Kind::set; }))
    throw InputError(sets_no_entry(file_name));
  return file.text;
}
} // namespace orthocone
