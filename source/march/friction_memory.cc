// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/friction_memory.h>

#include <orthocone/base/errors.h>
#include <orthocone/scene/parameters.h>
#include <orthocone/scene/surface_sample.h>

#include <algorithm>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

FrictionMemory::FrictionMemory(const Scene &scene)
    : scene_(scene),
      factor_(scene.parameters().friction.factor),
      is_there_(scene.parameters().friction.has_factor())
{
}

FrictionHistory FrictionMemory::history(const ContactState &state, const Index node,
                                        const unsigned int cycle) const
{
  const double area = scene_.pressed_areas()[node];
  const double speed = state.slip_speed.size() == 0 ? 0 : state.slip_speed[node];
  return {state.accumulated_slip[node],
          state.dissipated_energy[node] / area,
          std::max(0., state.force[3 * node]) / area,
          speed,
          state.status[node] == NodeStatus::slip,
          cycle};
}

VectorXd FrictionMemory::values(const ContactState &state, const unsigned int cycle) const
{
  VectorXd all(state.n_nodes());
  for (Index node = 0; node < all.size(); ++node)
    all[node] = factor_.value(history(state, node, cycle));
  return all;
}

VectorXd FrictionMemory::factors(const ContactState &state, const unsigned int cycle) const
{
  if (!is_there())
    return {};
  VectorXd all = values(state, cycle);
  for (Index node = 0; node < all.size(); ++node)
    check(all[node], state, node, cycle);
  return all;
}

/// The coefficients that it makes must be numbers > 0, too.
void FrictionMemory::check(const double factor, const ContactState &state, const Index node,
                           const unsigned int cycle) const
{
  const FrictionLaw &law = scene_.system().law(node);
  const bool is_fine = FrictionFactor::is_fine(factor) &&
                       (law.is_frictionless() || (positive.contains(factor * law.least_friction()) &&
                                                  positive.contains(factor * law.largest_friction())));
  if (is_fine)
    return;
  const FrictionHistory past = history(state, node, cycle);
  throw SolveError(
      "Friction/Factor = " + factor_.text() + " is " + value_text(factor) + " at " +
      place_text(Eigen::Vector3d(scene_.surface().nodes[static_cast<std::size_t>(node)].place())) +
      ", where s = " + value_text(past.slip) + " mm, w = " + value_text(past.energy) +
      " N/mm, p = " + value_text(past.pressure) + " MPa" +
      (factor_.has_speed() ? ", v = " + value_text(past.speed) + " mm/s" : "") +
      ", n = " + std::to_string(cycle) +
      ": allowed is a finite number > 0; max(1e-3, ...) and min(..., 10) around the expression "
      "keep it within bounds");
}

VectorXd FrictionMemory::speeds(const ContactState &before, const ContactState &after,
                                const double seconds) const
{
  if (!is_there() || !factor_.has_speed())
    return {};
  return seconds > 0 ? VectorXd((after.accumulated_slip - before.accumulated_slip) / seconds)
                     : VectorXd(VectorXd::Zero(after.n_nodes()));
}

double change_of_factor(const ContactState &before, const ContactState &after)
{
  double largest = 0;
  if (before.friction_factor.size() != after.friction_factor.size())
    return largest;
  for (Index node = 0; node < after.friction_factor.size(); ++node)
  {
    const double first = before.friction_factor[node], last = after.friction_factor[node];
    if (before.status[node] != NodeStatus::open && after.status[node] != NodeStatus::open)
      largest = std::max(largest, std::max(first, last) / std::min(first, last) - 1);
  }
  return largest;
}

/// The dissipation of a step takes the mean of the forces before and behind it, so that half of the fall
/// counts.
double energy_of_fall(const ContactState &before, const ContactState &after)
{
  double energy = 0;
  if (before.friction_factor.size() != after.friction_factor.size())
    return energy;
  for (Index node = 0; node < after.friction_factor.size(); ++node)
  {
    const double first = before.friction_factor[node], last = after.friction_factor[node];
    if (after.status[node] == NodeStatus::slip && last < first)
      energy +=
          (first - last) / (first + last) * (after.dissipated_energy[node] - before.dissipated_energy[node]);
  }
  return energy;
}
} // namespace orthocone
