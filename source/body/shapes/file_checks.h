// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>

namespace orthocone
{
/// Checks the mesh file that the options name, and its surfaces. Throws InputError, or FileError if it cannot
/// be read.
void check_mesh_file(const GeometryOptions &geometry);
} // namespace orthocone
