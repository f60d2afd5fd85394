// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/contact_state.h>

#include <orthocone/march/touching.h>

#include <algorithm>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

ContactState::ContactState(const NodeVector &gaps)
    : force(NodeVector::Zero(gaps.size())),
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
/// To be called with the status at the end of a step, and the slip at its beginning still in the state.
void remember_stick(ContactState &state, const Index node, const Vector2d &change)
{
  const Vector2d before = state.displacement.segment<2>(3 * node + 1);
  auto mark = state.slip_at_stick.segment<2>(2 * node);
  if (state.status[node] != NodeStatus::slip)
    mark = before + change;
  else if (change.dot(before - mark) < 0)
    mark = before;
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

void advance(ContactState &state, const ContactStep &step, const VectorXd &opening, const VectorXd &unknowns,
             const RigidMotion &motion, const WearLaw &wear)
{
  const ContactState before = state;
  // The displacement is (gap, change of slip), relative to the last step.
  const NodeVector d = step.displacement(unknowns);
  state.force = unknowns.head(d.size());
  state.status = step.statuses(unknowns, d);
  state.found_depth = before.wear_depth;
  state.motion = motion;
  for (Index node = 0; node < state.n_nodes(); ++node)
  {
    const Vector2d change = d.segment<2>(3 * node + 1);
    remember_stick(state, node, change);
    state.displacement[3 * node] = d[3 * node];
    state.displacement.segment<2>(3 * node + 1) += change;
    const double share = share_in_contact(before, state, node, opening[node]);
    state.accumulated_slip[node] += share * change.norm();
    // A node that sticks has no slip: what the solver's tolerance leaves may have any direction.
    if (state.status[node] == NodeStatus::stick)
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
