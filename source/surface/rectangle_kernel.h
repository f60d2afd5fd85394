// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "half_space_kernel.h"

namespace orthocone
{
/// The kernel of a unit force that is spread evenly over a rectangle of the size width x height (mm), as the
/// mean over an equal rectangle at a distance (mm): the place of the displacement less that of the force. To
/// 1e-10 of the kernel at its distance.
HalfSpaceKernel mean_over_rectangles(double width, double height, double distance_x, double distance_y);
} // namespace orthocone
