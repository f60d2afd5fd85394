// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "command_line.h"
#include "ending.h"

#include <orthocone/base/text.h>
#include <orthocone/scene/model_choice.h>
#include <orthocone/scene/parameters.h>

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

/// Throws InputError, with the name of the parameter file, where a lower body is not under all of the upper
/// one, or a line leaves the bodies: require_cover() and require_lines_inside().
void require_bodies_that_meet(const CommandLine &line, const Parameters &parameters,
                              const ModelSymmetry &symmetry);

/// Several processes read the same file, each for itself. Both throw InputError: the first one if they cannot
/// all read the file from its beginning (a pipe, for instance), the second one if their entries or options
/// differ.
void require_file_for_all(const std::string &path);
void require_same_for_all(const CommandLine &line, const Parameters &parameters);

/// Throws InputError for what several processes cannot compute together.
void require_shareable(const Parameters &parameters, const ModelChoice &model);
} // namespace orthocone
