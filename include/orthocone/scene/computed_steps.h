// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>

namespace orthocone
{
constexpr double most_counted_parts = 4e9; ///< of all steps, computed or jumped: their numbers have 32 bits

/// Whether cycles may be left out, because they would be like the one before.
bool may_jump(const LoadOptions &load, const WearOptions &wear);

/// The least number of steps that are computed, each counted with all its parts: all of them where no cycle
/// is jumped, and otherwise those of the cycles between the longest jumps.
double least_computed_parts(const LoadOptions &load, const WearOptions &wear);
} // namespace orthocone
