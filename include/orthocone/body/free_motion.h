// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body_unknowns.h>
#include <orthocone/surface/model_symmetry.h>

#include <string>

namespace orthocone
{
/// A rigid motion that nothing holds, neither the held face nor supports nor symmetry: "along x", "about z"
/// or the like; "" where there is none. All processes must call it.
std::string free_motion(const BodyUnknowns &unknowns, const ModelSymmetry &symmetry);
} // namespace orthocone
