// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "layer_schemes.h"

#include <stdexcept>

namespace orthocone::studies
{
using Eigen::Vector2d;

Layer::Layer(const OrthotropicFriction &law)
    : law_(law),
      s_(Vector2d(1 / (law.p_x * law.p_x), 1 / (law.p_y * law.p_y)))
{
  s_ /= s_.maxCoeff(); // its length means nothing
}

bool Layer::solve(const Vector2d a, const Vector2d &b, const Vector2d &c, Vector2d &t)
{
  constexpr unsigned int most_steps = 100;
  constexpr double tolerance = 1e-14;
  ++n_solves_;
  const Vector2d weights(1 / (law_.mu_x * law_.mu_x), 1 / (law_.mu_y * law_.mu_y));
  double lambda = 0;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    const Vector2d denominator = Vector2d::Ones() + lambda * c;
    t = (a - lambda * b).cwiseQuotient(denominator);
    const double excess = norm(t) - 1;
    if (std::abs(excess) <= tolerance)
      return true;
    const Vector2d rate = -(b + c.cwiseProduct(t)).cwiseQuotient(denominator);
    const double slope = weights.cwiseProduct(t).dot(rate) / (1 + excess);
    const double next = lambda - excess / slope;
    if (!(slope < 0 && next >= 0))
      return false;
    if (std::abs(next - lambda) <= tolerance * next)
      return true;
    lambda = next;
  }
  return false;
}

Vector2d Layer::euler(const Vector2d &top, const Vector2d &slip)
{
  Vector2d t = top - slip;
  if (norm(t) <= 1)
    return slip;
  if (!solve(t, Vector2d::Zero(), s_, t))
    throw std::runtime_error("backward Euler fails"); // Newton's method on a convex decreasing function
  return top - t;
}

/// The slip grows along the mean of the normals at the old force and the new one; where the node stuck, there
/// is no old normal.
Vector2d Layer::trapezoidal(const LayerStep &step)
{
  constexpr double rounding = 1e-10;
  const Vector2d old = step.old_top - step.slip;
  Vector2d t = step.top - step.slip;
  if (norm(t) <= 1 || norm(old) < 1 - rounding)
    return euler(step.top, step.slip);
  if (solve(t, 0.5 * s_.cwiseProduct(old), 0.5 * s_, t))
    return step.top - t;
  ++n_failures_;
  return euler(step.top, step.slip);
}

/// Backward Euler to the middle, as far again, and back to the ellipse along the normal.
Vector2d Layer::midpoint(const LayerStep &step)
{
  const Vector2d half = euler(0.5 * (step.old_top + step.top), step.slip);
  return euler(step.top, 2 * half - step.slip);
}

/// Extrapolated from one step and two half steps, and back to the ellipse along the normal.
Vector2d Layer::richardson(const LayerStep &step)
{
  const Vector2d whole = euler(step.top, step.slip);
  const Vector2d halves = euler(step.top, euler(0.5 * (step.old_top + step.top), step.slip));
  return euler(step.top, 2 * halves - whole);
}

Vector2d Layer::advance(const std::string &scheme, const LayerStep &step)
{
  // Two steps back: slip' = (3 s_1 - 4 s_0 + s_-1)/2 makes backward Euler from this slip.
  const Vector2d two_step = (4 * step.slip - step.previous_slip) / 3;
  if (scheme == "backward-euler")
    return euler(step.top, step.slip);
  if (scheme == "trapezoidal")
    return trapezoidal(step);
  if (scheme == "midpoint")
    return midpoint(step);
  if (scheme == "richardson-local")
    return richardson(step);
  if (scheme == "bdf2")
    return euler(step.top, step.is_first_of_leg ? step.slip : two_step);
  if (scheme == "bdf2-guarded")
  {
    // One step where the leg begins, where the node would stick, and where it stuck in the last step.
    const bool has_stuck = norm(step.top - step.slip) <= 1 || step.slip == step.previous_slip;
    return euler(step.top, step.is_first_of_leg || has_stuck ? step.slip : two_step);
  }
  throw std::runtime_error("there is no scheme '" + scheme + "'");
}
} // namespace orthocone::studies
