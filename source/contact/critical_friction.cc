// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/critical_friction.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector2d;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Friction that resists a slip along a direction relative to that which the slip takes from the normal
/// force.
class SlipResistance
{
public:
  SlipResistance(const OrthotropicFriction &law, const Matrix3d &block)
      : law_(law),
        weights_(slip_weights(law)),
        stiffness_(block.inverse())
  {
  }

  double along(const double angle) const
  {
    const Vector2d slip(std::cos(angle), std::sin(angle));
    const Vector2d weighted = weights_.cwiseProduct(slip);
    const double lost =
        std::abs(stiffness_.row(0).tail<2>().dot(slip)) * dual_norm(law_, weighted[0], weighted[1]);
    const double resistance = weighted.dot(stiffness_.bottomRightCorner<2, 2>() * slip);
    if (resistance <= 0)
      return 0;
    return lost > 0 ? resistance / lost : infinity;
  }

private:
  const OrthotropicFriction &law_;
  Vector2d weights_;
  Matrix3d stiffness_;
};

/// Least value over the half circle: the best point of a grid, and golden sections between its neighbours.
double least_over_directions(const SlipResistance &resistance)
{
  constexpr unsigned int n_grid = 90, n_sections = 40;
  constexpr double spacing = 3.14159265358979323846 / n_grid, golden = 0.61803398874989485;
  double best = 0;
  for (unsigned int i = 1; i < n_grid; ++i)
    if (resistance.along(i * spacing) < resistance.along(best))
      best = i * spacing;
  double left = best - spacing, right = best + spacing;
  for (unsigned int i = 0; i < n_sections; ++i)
  {
    const double lower = right - golden * (right - left);
    const double upper = left + golden * (right - left);
    if (resistance.along(lower) < resistance.along(upper))
      right = upper;
    else
      left = lower;
  }
  return std::min(resistance.along(best), resistance.along(0.5 * (left + right)));
}
} // namespace

double critical_friction_factor(const OrthotropicFriction &law, const Matrix3d &block)
{
  constexpr double quarter_turn = 1.57079632679489662;
  const SlipResistance resistance(law, block);
  const bool is_x_held = block(0, 1) == 0 && block(1, 2) == 0;
  const bool is_y_held = block(0, 2) == 0 && block(1, 2) == 0;
  if ((is_x_held && is_y_held) || is_frictionless(law))
    return infinity;
  if (is_x_held)
    return resistance.along(quarter_turn);
  return is_y_held ? resistance.along(0) : least_over_directions(resistance);
}

CriticalFriction critical_friction(const ContactProblem &problem)
{
  CriticalFriction critical;
  for (Index node = 0; node < problem.n_nodes(); ++node)
  {
    const double factor =
        critical_friction_factor(problem.law(node), problem.compliance().diagonal_block(node));
    if (factor < critical.factor)
      critical = {factor, node};
  }
  return critical;
}
} // namespace orthocone
