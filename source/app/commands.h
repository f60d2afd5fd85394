// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "command_line.h"
#include "ending.h"

#include <orthocone/base/text.h>
#include <orthocone/scene/parameters.h>
#include <orthocone/scene/model_choice.h>

namespace orthocone
{
/// Prints on standard error why the program ends. Returns the exit code.
int fail(const Ending &ending);

/// What `function` returns. InputError and TooLargeError become an InputError that names the parameter file.
template<typename Function>
auto naming_file(const CommandLine &line, const Function &function)
{
  const auto named = [&](const std::exception &error)
  { return InputError(shown_path(line.parameter_file) + ": " + error.what()); };
  try
  {
    return function();
  }
  catch (const InputError &error)
  {
    throw named(error);
  }
  catch (const TooLargeError &error)
  {
    throw named(error);
  }
}

/// Checks entries against each other. Throws InputError, which names the file.
ModelChoice resolve(const CommandLine &line, const Parameters &parameters);

/// --check: prints the resolved model and its cost. Returns the exit code.
int check(const CommandLine &line, const Parameters &parameters);

/// Runs the program. Returns the exit code.
int run(const CommandLine &line, const ParameterFile &file);
} // namespace orthocone
