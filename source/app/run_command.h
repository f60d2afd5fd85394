// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "command_line.h"

#include <orthocone/scene/parameters.h>

namespace orthocone
{
/// Whether a search for the mesh or for parts of load steps comes before the run.
bool searches(const Parameters &given);

/// Runs the program. Returns the exit code.
int run(const CommandLine &line, const ParameterFile &file);
} // namespace orthocone
