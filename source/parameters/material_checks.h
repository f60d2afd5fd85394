// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

namespace orthocone
{
/// Constants that store energy under every strain; regions that there are. Throws InputError.
void check_material(const Parameters &parameters);
} // namespace orthocone
