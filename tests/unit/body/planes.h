// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/model_symmetry.h>

namespace orthocone::test
{
constexpr SymmetryPlanes full{};
constexpr SymmetryPlanes half_x{true, false};
constexpr SymmetryPlanes half_y{false, true};
constexpr SymmetryPlanes quarter{true, true};
} // namespace orthocone::test
