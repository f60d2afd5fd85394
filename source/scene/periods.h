// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>

namespace orthocone
{
/// Values of the entries that say when a cycle ends as it began.
Codec<double> period_codec();

/// Throws InputError where such an entry of section Load program is set and slip wears the body.
void check_no_wear(const std::string &entry, double bound, const WearOptions &wear);

/// Adds warnings of a bound that rounding hides, or that is loose.
void warn_of_period(const std::string &entry, double bound, double tolerance,
                    std::vector<std::string> &warnings);
} // namespace orthocone
