// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <stdexcept>
#include <string>

namespace orthocone
{
/// Exit codes of the program, fixed by the contract with users.
enum class ExitCode : int
{
  done = 0,
  wrong_input = 2,
  unsolved_step = 3,
  file_error = 4,
  interrupted = 130,
};

/// The command line or the parameter file is wrong. `what()` is the complete sentence for the user: file,
/// entry, value given, what is allowed.
struct InputError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file or folder could not be read or written. `what()` is the complete sentence for the user.
struct FileError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A body cannot be solved: an iteration does not settle, or there is nothing to precondition it with.
/// `what()` is the complete sentence for the user, without a full stop.
struct SolveError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A model has more cells, unknowns or entries than the program can count or mesh, whatever the memory.
struct TooLargeError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};
} // namespace orthocone
