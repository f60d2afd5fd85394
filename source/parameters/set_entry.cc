// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "faults.h"
#include "readers.h"

#include <orthocone/parameters/errors.h>

#include <sstream>

namespace orthocone
{
namespace
{
/// What a pattern allows, out of deal.II's sentence: "The string <VALUE> does not match the given pattern
/// <ALLOWED>." Searched from the end, since VALUE may be any text.
std::string allowed(const dealii::ExceptionBase &exception)
{
  std::ostringstream text;
  exception.print_info(text);
  const std::string sentence = text.str();
  const std::string before = "the given pattern <";
  const auto first = sentence.rfind(before);
  const auto last = sentence.rfind(">.");
  if (first == std::string::npos || last == std::string::npos || last < first)
    return "another value";
  return sentence.substr(first + before.size(), last - first - before.size());
}
} // namespace

void set_entry(const std::string &place, const std::string &name, const std::string &value,
               dealii::ParameterHandler &handler)
{
  if (!is_entry(name))
    throw InputError(place + not_an_entry(name));
  const auto slash = name.find('/');
  handler.enter_subsection(name.substr(0, slash));
  try
  {
    handler.set(name.substr(slash + 1), value);
  }
  catch (const dealii::ExceptionBase &exception)
  {
    throw InputError(place + name + (value.empty() ? " is empty" : " = " + shown(value)) + remark(value) +
                     ": allowed is " + allowed(exception));
  }
  handler.leave_subsection();
}

std::string sets_no_entry(const std::string &file_name)
{
  return file_name + ": sets no entry; 'orthocone --defaults' prints a complete parameter file";
}
} // namespace orthocone
