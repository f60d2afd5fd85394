// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "command_line.h"

#include <orthocone/scene/parameters.h>
#include <orthocone/scene/model_choice.h>

#include <string>

namespace orthocone
{
/// Several processes read the same file, each for itself. Both throw InputError: the first one if they cannot
/// all read the file from its beginning (a pipe, for instance), the second one if their entries or options
/// differ.
void require_file_for_all(const std::string &path);
void require_same_for_all(const CommandLine &line, const Parameters &parameters);

/// Throws InputError for what several processes cannot compute together.
void require_shareable(const Parameters &parameters, const ModelChoice &model);
} // namespace orthocone
