// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

namespace orthocone
{
constexpr double pi = 3.14159265358979323846;
constexpr double radians_per_degree = pi / 180;

/// value / scale; 0 for a value of 0, even if the scale is 0, too.
constexpr double relative(const double value, const double scale)
{
  return value == 0 ? 0 : value / scale;
}
} // namespace orthocone
