// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "faults.h"
#include "readers.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

namespace orthocone
{
void set_entry(const std::string &place, const std::string &name, const std::string &value, EntryTable &table)
{
  const Entry *const entry = table.find(name);
  if (!entry)
    throw InputError(place + not_an_entry(name));
  if (!entry->allowed.test(value))
    throw InputError(place + name + (value.empty() ? " is empty" : " = " + shown(value)) + remark(value) +
                     ": allowed is " + entry->allowed.description_for(value));
  entry->assign(value);
}

std::string sets_no_entry(const std::string &file_name)
{
  return shown_path(file_name) + ": sets no entry; 'orthocone --defaults' prints a complete parameter file";
}
} // namespace orthocone
