// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/touching.h>

#include <algorithm>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
bool is_open(const ContactState &state, const Index node)
{
  return state.status[node] == NodeStatus::open;
}
} // namespace

double share_in_contact(const ContactState &before, const ContactState &after, const Index node,
                        const double compliance)
{
  const bool was_open = is_open(before, node);
  if (was_open == is_open(after, node))
    return was_open ? 0 : 1;
  // The step finds the surface that all wear before it has left.
  const double found = before.wear_depth[node] - before.found_depth[node];
  const double gap = was_open ? before.displacement[3 * node] + found : after.displacement[3 * node];
  const double force = was_open ? after.force[3 * node] : before.force[3 * node];
  return force > 0 ? force / (force + std::max(gap, 0.) / compliance) : 0;
}

double work_without_contact(const ContactState &before, const ContactState &after, const VectorXd &opening)
{
  double work = 0;
  for (Index node = 0; node < after.n_nodes(); ++node)
    if (is_open(before, node) != is_open(after, node))
    {
      const Vector3d force = 0.5 * (before.force + after.force).segment<3>(3 * node);
      const Vector3d increment = (after.displacement - before.displacement).segment<3>(3 * node);
      const double apart = 1 - share_in_contact(before, after, node, opening[node]);
      work += force[0] * increment[0] + apart * force.tail<2>().dot(increment.tail<2>());
    }
  return work;
}
} // namespace orthocone
