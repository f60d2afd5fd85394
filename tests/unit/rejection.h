// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/errors.h>

#include <string>

namespace orthocone::test
{
/// What an InputError that `call` throws says; empty if it throws none.
template<typename Call>
std::string rejection_of(const Call &call)
{
  try
  {
    call();
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return {};
}
} // namespace orthocone::test
