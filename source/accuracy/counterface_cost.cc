// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "counterface_cost.h"

#include "cost_constants.h"

#include <algorithm>
#include <cmath>

namespace orthocone
{
// Hierarchical matrices have n log n numbers, of which the coarser meshes together add a third. Cross
// approximation looks at all pairs of nodes, but the time of what follows grows as n^1.5 up to 10 000 nodes.
CounterfaceCost counterface_cost(const ObstacleOptions &obstacle, const double n_contact_nodes)
{
  if (!obstacle.kind.chosen().gives_way())
    return {};
  const double n = n_contact_nodes, logarithm = std::max(1., std::log(n) - cost::hierarchical_log);
  return {cost::hierarchical_bytes * n * logarithm / cost::gigabyte,
          cost::hierarchical_set_up * std::pow(n, 1.5), cost::hierarchical_cycle * n * logarithm};
}
} // namespace orthocone
