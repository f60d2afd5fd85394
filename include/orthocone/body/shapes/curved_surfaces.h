// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>

namespace orthocone
{
/// Adds the entry Curved surfaces, which counts where `is_chosen` holds.
void declare_curved_surfaces(GeometryOptions &geometry, const Condition &is_chosen, Section &section);

/// Throws InputError where a section has a surface that is none of its own.
void check_curved_surfaces(const GeometryOptions &geometry);
} // namespace orthocone
