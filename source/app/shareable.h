// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/parameters.h>
#include <orthocone/scene/model_choice.h>

namespace orthocone
{
/// Throws InputError for what several processes cannot compute together.
void require_shareable(const Parameters &parameters, const ModelChoice &model);
} // namespace orthocone
