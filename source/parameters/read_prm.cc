// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "faults.h"
#include "readers.h"
#include "statements.h"

#include <orthocone/parameters/errors.h>

namespace orthocone
{
namespace
{
std::string quoted(const Statement &subsection)
{
  return "'subsection " + shown(subsection.name) + "'";
}

/// No section has sections of its own; `open` is the section that the statement is in, if any.
void check_subsection(const Statement &statement, const Statement *const open)
{
  if (!open && !is_section(statement.name))
    throw InputError(statement.place + ": " + not_a_section(statement.name));
  if (open && is_section(statement.name))
    throw InputError(open->place + ": " + quoted(*open) + " has no 'end' before " + quoted(statement) + " (" +
                     statement.place + ")");
  if (open)
    throw InputError(statement.place + ": " + not_a_section(open->name + "/" + statement.name));
}

void set(const Statement &statement, const Statement *const open, dealii::ParameterHandler &handler)
{
  const std::string &name = statement.name;
  const std::string place = statement.place + ": ";
  if (const auto slash = name.find('/'); is_entry(name))
    throw InputError(place + name + " is set within 'subsection " + name.substr(0, slash) + "', as 'set " +
                     name.substr(slash + 1) + " = " + shown(statement.value) + "'");
  set_entry(place, (open ? open->name + "/" : "") + name, statement.value, handler);
}
} // namespace

void read_prm(const std::string &file_name, dealii::ParameterHandler &handler)
{
  const auto statements = read_statements(file_name);
  const Statement *open = nullptr;
  bool sets_anything = false;
  for (const Statement &statement : statements)
    switch (statement.kind)
    {
    case Statement::Kind::subsection:
      check_subsection(statement, open);
      open = &statement;
      break;
    case Statement::Kind::set:
      set(statement, open, handler);
      sets_anything = true;
      break;
    case Statement::Kind::end:
      if (!open)
        throw InputError(statement.place + ": 'end' has no 'subsection'");
      open = nullptr;
      break;
    }
  if (open)
    throw InputError(open->place + ": " + quoted(*open) + " has no 'end'");
  if (!sets_anything)
    throw InputError(sets_no_entry(file_name));
}
} // namespace orthocone
