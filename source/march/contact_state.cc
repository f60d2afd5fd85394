// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/contact_state.h>

#include <orthocone/base/numbers.h>

#include <algorithm>
#include <cmath>

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
/// Share of the step in which a node that ends with a gap touched the plane, if its normal force fell
/// linearly from `before` to the force that would pull the gap shut (docs/theory.md, section 4).
double share_in_contact(const double before, const double gap, const double compliance)
{
  return before > 0 ? before / (before + std::max(gap, 0.) / compliance) : 0;
}

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
  state.found_depth = state.wear_depth;
  // The displacement is (gap, change of slip), relative to the last step.
  const NodeVector d = step.displacement(unknowns);
  const NodeVector force = unknowns.head(d.size());
  const std::vector<NodeStatus> statuses = step.statuses(unknowns, d);
  for (Index node = 0; node < state.n_nodes(); ++node)
  {
    const Vector2d change = d.segment<2>(3 * node + 1);
    const bool was_open = state.status[node] == NodeStatus::open;
    state.status[node] = statuses[node];
    const bool is_open = state.status[node] == NodeStatus::open;
    if (!was_open || !is_open)
      state.accumulated_slip[node] += change.norm();
    const double share = is_open ? share_in_contact(state.force[3 * node], d[3 * node], opening[node]) : 1;
    // A node that sticks has no slip: what the solver's tolerance leaves may have any direction.
    if (state.status[node] != NodeStatus::stick)
    {
      const double dissipated =
          share * dissipation(state.force.segment<2>(3 * node + 1), force.segment<2>(3 * node + 1), change);
      state.dissipated_energy[node] += dissipated;
      const double normal_force = share * 0.5 * (state.force[3 * node] + force[3 * node]);
      state.wear_depth[node] += wear.depth(node, {normal_force, change.norm(), dissipated});
    }
    remember_stick(state, node, change);
    state.displacement[3 * node] = d[3 * node];
    state.displacement.segment<2>(3 * node + 1) += change;
  }
  state.force = force;
  state.motion = motion;
}
} // namespace orthocone
