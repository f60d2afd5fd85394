// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Formulas for the projection onto the elliptic cone, as one may think of them; the program's own is
// project().
#pragma once

#include <orthocone/contact/law/friction_law.h>

#include <string>
#include <vector>

namespace orthocone::studies
{
using Formula = Eigen::Vector3d (*)(const OrthotropicFriction &, const Eigen::Vector3d &);

/// The formula of that name; throws std::runtime_error if there is none. Points without an answer are NaN.
Formula projection_formula(const std::string &name);
} // namespace orthocone::studies
