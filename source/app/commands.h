// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "command_line.h"

#include <orthocone/base/errors.h>
#include <orthocone/parameters/parameters.h>
#include <orthocone/scene/model_choice.h>

namespace orthocone
{
/// Prints on standard error why the program ends. Returns the exit code.
int fail(ExitCode code, const std::string &message);

/// Checks entries against each other. Throws InputError, which names the file.
ModelChoice resolve(const CommandLine &line, const Parameters &parameters);

/// --check: prints the resolved model and its cost. Returns the exit code.
int check(const CommandLine &line, const Parameters &parameters);

/// Runs the program. Returns the exit code.
int run(const CommandLine &line, const ParameterFile &file);
} // namespace orthocone
