// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/cycle_row.h>

#include <Eigen/Core>

#include <vector>

namespace orthocone
{
/// The held face at the end of a load step, seen along the plane of contact.
struct LoopPoint
{
  Eigen::Vector2d motion = Eigen::Vector2d::Zero(); ///< of the face (x, y), mm
  Eigen::Vector2d force = Eigen::Vector2d::Zero();  ///< on the face (x, y), N
  double normal_force = 0;                          ///< that presses, N
  double approach = 0;                              ///< motion of the face along z, mm
};

/// The figures of a cycle whose states are `points`: the one at its start, then one a load step, between
/// which all is linear. Cycles without tangential motion have
/// zeros and nothing. docs/theory.md, section 6, "The fretting loop".
LoopFigures loop_figures(const std::vector<LoopPoint> &points);
} // namespace orthocone
