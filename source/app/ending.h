// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/errors.h>

#include <string>

namespace orthocone
{
/// How a command ended; `message` says why it did not come to its end.
struct Ending
{
  ExitCode code = ExitCode::done;
  std::string message{};
};

/// The ending that belongs to the exception that is being handled: the one table from exceptions to exit
/// codes. To be called within a handler. Rethrows what is no std::exception.
Ending ending_of_exception();
} // namespace orthocone
