// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/grid_half_space.h>

#include <vector>

namespace orthocone
{
/// What tractions on its surface do at a point of a half-space.
struct HalfSpaceFields
{
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero(); ///< mm, against the far field
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();     ///< entry (i, j): of displacement i along j
};

/// The fields at a point (mm, z >= 0) of the half-space above a grid about x = y = 0, of which each patch has
/// even tractions (MPa, global axes, as many as nodes): sums of closed forms over the corners of the patches.
/// A point on the surface, where they may jump, is taken a millionth of a patch below it. The grid must not
/// be periodic.
HalfSpaceFields fields_below(const SurfaceGrid &grid, const HalfSpace &half_space,
                             const std::vector<Eigen::Vector3d> &tractions, const Eigen::Vector3d &point);
} // namespace orthocone
