// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <array>

namespace orthocone
{
constexpr unsigned int n_rigid_components = 6;

/// Names of the components of a rigid motion, and of the force and moment that do work on them, as users
/// write them.
constexpr std::array<const char *, n_rigid_components> motion_names{{"ux", "uy", "uz", "rx", "ry", "rz"}};
constexpr std::array<const char *, n_rigid_components> wrench_names{{"Fx", "Fy", "Fz", "Mx", "My", "Mz"}};
} // namespace orthocone
