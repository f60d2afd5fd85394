// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/contact_state.h>

namespace orthocone
{
using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

ContactState::ContactState(const Index n_nodes)
    : force(NodeVector::Zero(3 * n_nodes)),
      displacement(NodeVector::Zero(3 * n_nodes)),
      accumulated_slip(VectorXd::Zero(n_nodes)),
      dissipated_energy(VectorXd::Zero(n_nodes)),
      status(n_nodes, NodeStatus::open)
{
}

void advance(ContactState &state, const ContactProblem &problem, const NodeVector &force,
             const std::array<double, 3> &top)
{
  // Relative to the last step, the problem's displacement is (gap, change of slip).
  const NodeVector d = problem.displacement(force);
  for (Index node = 0; node < state.n_nodes(); ++node)
  {
    const Vector2d change = d.segment<2>(3 * node + 1);
    const Vector2d mean_force = 0.5 * (state.force.segment<2>(3 * node + 1) + force.segment<2>(3 * node + 1));
    state.status[node] = problem.status(node, force, d);
    if (state.status[node] != NodeStatus::open)
      state.accumulated_slip[node] += change.norm();
    state.dissipated_energy[node] -= mean_force.dot(change);
    state.displacement[3 * node] = d[3 * node];
    state.displacement.segment<2>(3 * node + 1) += change;
  }
  state.force = force;
  state.top = top;
}
} // namespace orthocone
