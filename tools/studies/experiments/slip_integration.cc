// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene.h"

#include <iostream>
#include <stdexcept>

namespace orthocone::studies
{
namespace
{
using Eigen::Index;

struct Work
{
  double dissipated = 0;
  double driven = 0; ///< by friction, instead of being taken
};

/// Work of the friction forces in a step: by the mean of the forces, or by the new one where the slip
/// reverses.
void add_work(const ContactState &before, const ContactState &after, const unsigned int n_copies, Work &work)
{
  for (Index node = 0; node < after.n_nodes(); ++node)
  {
    const Index x = 3 * node + 1;
    const Eigen::Vector2d change = after.displacement.segment<2>(x) - before.displacement.segment<2>(x);
    const Eigen::Vector2d old = before.force.segment<2>(x), force = after.force.segment<2>(x);
    work.dissipated += n_copies * dissipation(old, force, change);
    work.driven += n_copies * std::max(0., force.dot(change));
  }
}

/// What makes backward Euler the second-order formula of two steps: the slip from which it starts is
/// (4 s_0 - s_-1)/3. Nodes that did not slip in the last step take one step.
void extrapolate(ContactState &state, const NodeVector &previous)
{
  for (Index node = 0; node < state.n_nodes(); ++node)
    if (const Index x = 3 * node + 1; state.status[node] == NodeStatus::slip)
      state.displacement.segment<2>(x) += (state.displacement.segment<2>(x) - previous.segment<2>(x)) / 3;
}

Index nearest_node(const ContactSurface &surface, const double x, const double y)
{
  Index nearest = 0;
  double least = 1e300;
  for (std::size_t node = 0; node < surface.nodes.size(); ++node)
  {
    const auto &position = surface.nodes[node].position;
    const double distance = std::hypot(position[0] - x, position[1] - y);
    if (distance < least)
    {
      least = distance;
      nearest = static_cast<Index>(node);
    }
  }
  return nearest;
}
} // namespace

void slip_integration(const Words &words)
{
  const SceneWords scene(words);
  const auto scheme = scene.options.find("scheme");
  const bool is_two_step = scheme != scene.options.end() && scheme->second == "bdf2";
  const Scene model(scene.parameters, choose_model(scene.parameters));
  const Index probe = nearest_node(model.surface(), scene.number("x", 6.72), scene.number("y", 6.72));
  const unsigned int n_copies = model.symmetry().n_copies();
  StepSolver solver(model);
  ContactState state(model.gaps());
  NodeVector previous = state.displacement;
  Work work;
  std::cout << "step,slip_x,slip_y,dissipation,driven\n";
  for (const LoadStep &step : LoadProgram(scene.parameters.load).steps())
  {
    const ContactState before = state;
    if (is_two_step && step.step_of_leg > 1)
      extrapolate(state, previous);
    if (!solver.solve(state, step).converged)
      throw std::runtime_error("step " + std::to_string(step.number) + " is not solved");
    solver.accept(before, state, step);
    add_work(before, state, n_copies, work);
    previous = before.displacement;
    std::cout << step.number << "," << state.displacement[3 * probe + 1] << ","
              << state.displacement[3 * probe + 2] << "," << work.dissipated << "," << work.driven << "\n";
  }
}
} // namespace orthocone::studies
