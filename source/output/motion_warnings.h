// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/output/summary.h>

#include <string>
#include <vector>

namespace orthocone
{
/// Warns of states that are beyond the small strains and slides of the theory, whatever led there.
void warn_of_large_motions(const RunRecord &record, std::vector<std::string> &warnings);
} // namespace orthocone
