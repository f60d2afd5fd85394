// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

namespace orthocone
{
/// Throws InputError unless the constants store energy under every strain, and the regions exist.
void check_material(const Parameters &parameters);
} // namespace orthocone
