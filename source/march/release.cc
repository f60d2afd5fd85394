// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "release.h"

#include <algorithm>
#include <limits>

namespace orthocone
{
using Eigen::Index;

bool presses_nothing(const FreeFace &face, const std::vector<unsigned int> &components)
{
  constexpr unsigned int normal = 2;
  return std::find(components.begin(), components.end(), normal) != components.end() &&
         !face.has_stiffness() && face.balance().isZero(0);
}

bool opens_along_z(const Scene &scene)
{
  constexpr double least = 0.1; // cosine
  for (std::size_t node = 0; node < scene.surface().nodes.size(); ++node)
    if (!(scene.axes().normal(node)[2] > least))
      return false;
  return true;
}

double opening_motion(const NodeVector &free_gap, const LocalAxes &axes)
{
  double motion = -std::numeric_limits<double>::infinity();
  for (Index node = 0; node < free_gap.size() / 3; ++node)
    motion = std::max(motion, -free_gap[3 * node] / axes.normal(static_cast<std::size_t>(node))[2]);
  return motion;
}
} // namespace orthocone
