// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "command_line.h"

#include <orthocone/scene/parameters.h>

namespace orthocone
{
/// --check: prints the resolved model and its cost. Returns the exit code.
int check(const CommandLine &line, const Parameters &parameters);
} // namespace orthocone
