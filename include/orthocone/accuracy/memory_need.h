// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Models that are not likely to fit into the memory, or that a factorization cannot count.
#pragma once

#include <orthocone/base/memory.h>
#include <orthocone/body/shapes/shape.h>

#include <string>

namespace orthocone
{
/// Throws TooLargeError if the stiffness or the compliance of such a model have more entries than a
/// factorization can count, whatever the memory.
void require_countable(const ModelSize &size);

/// Whether the model is likely to need more memory than `gigabytes`. Meshes it and finds its order only where
/// the answer depends on this.
bool is_too_large(const Parameters &parameters, const ModelSymmetry &symmetry, double gigabytes);

/// The sentence on a model that needs `needed` GB, if these exceed the limit, or "".
std::string lack_of_memory(double needed, const MemoryLimit &limit);

/// Throws TooLargeError as require_countable() does, or InputError if the model is likely to need more memory
/// than the limit. `parameters` have the resolved mesh.
void require_memory(const Parameters &parameters, const ModelSymmetry &symmetry, const MemoryLimit &limit);
} // namespace orthocone
