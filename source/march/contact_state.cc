// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/contact_state.h>

#include <orthocone/march/slip_memory.h>

#include <algorithm>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

ContactState::ContactState(const NodeVector &gaps, const Index n_loads)
    : loads(VectorXd::Zero(n_loads)),
      force(NodeVector::Zero(gaps.size())),
      displacement(gaps),
      accumulated_slip(VectorXd::Zero(gaps.size() / 3)),
      dissipated_energy(VectorXd::Zero(gaps.size() / 3)),
      wear_depth(VectorXd::Zero(gaps.size() / 3)),
      found_depth(VectorXd::Zero(gaps.size() / 3)),
      slip_at_stick(VectorXd::Zero(gaps.size() / 3 * 2)),
      status(gaps.size() / 3, NodeStatus::open)
{
}

namespace
{
/// What the step does to a node. `found` is the status that the law gives.
NodeStep node_step(const ContactState &before, const NodeStatus found, const Index node)
{
  NodeStep of_node;
  of_node.before = before.status[node];
  of_node.found = found;
  of_node.slip = before.displacement.segment<2>(3 * node + 1) - before.slip_at_stick.segment<2>(2 * node);
  if (of_node.before == NodeStatus::open)
    of_node.gap = before.displacement[3 * node] + before.wear_depth[node] - before.found_depth[node];
  return of_node;
}

bool is_open(const ContactState &state, const Index node)
{
  return state.status[node] == NodeStatus::open;
}
} // namespace

// The mean of the forces before and after is exact while they are proportional. Where the old force drives
// the slip, the slip reverses within the step: then all of it counts against the force that the law gives at
// the end, unless the old force is small against that. The result is continuous in both forces, because
// rounding must not decide on the case.
double dissipation(const Vector2d &before, const Vector2d &after, const Vector2d &change)
{
  const double old_work = -before.dot(change);
  const double new_work = -after.dot(change);
  return 0.5 * (new_work + (old_work < 0 ? std::min(-old_work, new_work) : old_work));
}

FrictionLaw law_of(const ContactSystem &system, const ContactState &state, const Index node)
{
  return state.friction_factor.size() == 0 ? system.law(node)
                                           : system.law(node).scaled(state.friction_factor[node]);
}

NodeVector unworn_displacement(const ContactState &state)
{
  NodeVector displacement = state.displacement;
  for (Index node = 0; node < state.n_nodes(); ++node)
    displacement[3 * node] -= state.found_depth[node];
  return displacement;
}

double slip_since_stick(const ContactState &state, const Index node)
{
  return (state.displacement.segment<2>(3 * node + 1) - state.slip_at_stick.segment<2>(2 * node)).norm();
}

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

void advance(ContactState &state, const ContactStep &step, const VectorXd &opening, const VectorXd &unknowns,
             const RigidMotion &motion, const WearLaw &wear, const double tolerance)
{
  const ContactState before = state;
  // The displacement is (gap, change of slip), relative to the last step.
  const NodeVector d = step.displacement(unknowns);
  state.force = unknowns.head(d.size());
  const std::vector<NodeStatus> found = step.statuses(unknowns, d);
  const double unresolved = unresolved_slip(state.force, opening, tolerance);
  state.found_depth = before.wear_depth;
  state.motion = motion;
  for (Index node = 0; node < state.n_nodes(); ++node)
  {
    const Vector2d change = d.segment<2>(3 * node + 1);
    NodeStep of_node = node_step(before, found[node], node);
    of_node.change = change;
    of_node.reserve = opening[node] * friction_reserve(step.law(node), state.force.segment<3>(3 * node));
    of_node.unresolved = unresolved;
    state.status[node] = status_behind(of_node);
    state.displacement[3 * node] = d[3 * node];
    state.displacement.segment<2>(3 * node + 1) += change;
    state.slip_at_stick.segment<2>(2 * node) =
        state.displacement.segment<2>(3 * node + 1) - slip_behind(of_node);
    const double share = share_in_contact(before, state, node, opening[node]);
    state.accumulated_slip[node] += share * change.norm();
    // A node that sticks has no slip: what the solver's tolerance leaves may have any direction.
    if (found[node] == NodeStatus::stick)
      continue;
    const double dissipated = share * dissipation(before.force.segment<2>(3 * node + 1),
                                                  state.force.segment<2>(3 * node + 1), change);
    // What a node that closes does not carry at first others do: the wear of a given force is that of all of
    // it.
    const double mean_force = 0.5 * (before.force[3 * node] + state.force[3 * node]);
    const double normal_force = state.status[node] == NodeStatus::open ? share * mean_force : mean_force;
    state.dissipated_energy[node] += dissipated;
    state.wear_depth[node] += wear.depth(node, {normal_force, change.norm(), dissipated});
  }
}
} // namespace orthocone
