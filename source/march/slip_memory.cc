// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/slip_memory.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Vector2d;

namespace
{
/// 1 up to `unresolved`, 0 from twice that on.
double fading(const double value, const double unresolved)
{
  if (value <= unresolved)
    return 1;
  return value < 2 * unresolved ? 2 - value / unresolved : 0;
}

/// Share of the slip until now that a change forgets because it goes back.
double turned_share(const Vector2d &slip, const Vector2d &change, const double unresolved)
{
  const double length = slip.norm();
  const double back = length > 0 ? -change.dot(slip) / length - unresolved : 0;
  return back > 0 ? std::min(1., back / std::max(change.norm() - unresolved, unresolved)) : 0;
}
} // namespace

// The residual bounds the error of all nodes together; one node may have a good part of it.
double unresolved_slip(const NodeVector &force, const Eigen::VectorXd &compliance, const double tolerance)
{
  constexpr double many = 100, most = 1e-5; // a lax tolerance must not make all nodes stick
  double largest = 0;
  for (Eigen::Index node = 0; node < compliance.size(); ++node)
    largest = std::max(largest, compliance[node] * force.segment<3>(3 * node).norm());
  return std::min(many * tolerance, most) * largest;
}

// The friction coefficient is taken along the force, but must stay defined where the force has no direction.
double friction_reserve(const FrictionLaw &law, const Eigen::Vector3d &force)
{
  if (force[0] <= 0 || law.is_frictionless())
    return 0;
  const double load = law.load(force.tail<2>()) / force[0];
  const double friction = force.tail<2>().norm() / force[0] + (1 - load) * law.mean_friction();
  return friction * std::max(0., (1 - load) * force[0]);
}

NodeStatus status_behind(const NodeStep &step)
{
  const bool touches = step.before != NodeStatus::open && step.found != NodeStatus::open;
  const bool rests = step.change.norm() <= step.unresolved && step.reserve <= step.unresolved;
  return touches && rests ? step.before : step.found;
}

Vector2d slip_behind(const NodeStep &step)
{
  if (step.found == NodeStatus::open)
    return step.slip;
  const Vector2d slip = fading(step.gap, step.unresolved) * step.slip;
  if (step.found == NodeStatus::stick)
    return fading(step.reserve, step.unresolved) * (slip + step.change);
  return (1 - turned_share(slip, step.change, step.unresolved)) * slip + step.change;
}
} // namespace orthocone
