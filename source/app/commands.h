// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "command_line.h"

#include <orthocone/base/errors.h>
#include <orthocone/parameters/parameters.h>
#include <orthocone/scene/model_choice.h>

namespace orthocone
{
/// Tells the user why the program ends, on standard error. Returns the exit code.
int fail(ExitCode code, const std::string &message);

/// Checks what entries have to do with each other; faults are told with the name of the file.
ModelChoice resolve(const CommandLine &line, const Parameters &parameters);

/// --check: prints the resolved model and what it will cost. Returns the exit code.
int check(const CommandLine &line, const Parameters &parameters);

/// The run itself. Returns the exit code.
int run(const CommandLine &line, const ParameterFile &file);
} // namespace orthocone
