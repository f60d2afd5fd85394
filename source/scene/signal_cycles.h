// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>

namespace orthocone
{
/// Sets the cycles of the rows of a program file, as they are found in its signal behind `preload`. Where
/// none is found, all rows are one cycle.
void find_cycles(std::vector<Leg> &rows, const std::vector<Leg> &preload);
} // namespace orthocone
