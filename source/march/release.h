// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Steps in which nothing presses the body any more.
#pragma once

#include <orthocone/contact/problem/free_face.h>
#include <orthocone/scene/scene.h>

#include <vector>

namespace orthocone
{
/// Whether the body is free along z, and no force acts on it.
bool presses_nothing(const FreeFace &face, const std::vector<unsigned int> &components);

/// Whether a motion along z opens all gaps. It opens none of a shaft in its bore.
bool opens_along_z(const Scene &scene);

/// The least motion along z that leaves no node under pressure, mm.
double opening_motion(const NodeVector &free_gap, const LocalAxes &axes);
} // namespace orthocone
