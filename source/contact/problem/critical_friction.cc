// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/problem/critical_friction.h>

#include <orthocone/base/numbers.h>

#include <boost/math/tools/minima.hpp>

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

/// The friction that resists a slip along a direction, relative to the friction that is lost as the slip
/// reduces the normal force.
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

/// Least value over the half circle: the minimum between the neighbours of a grid's best point.
double least_over_directions(const SlipResistance &resistance)
{
  constexpr unsigned int n_grid = 90; // steps of two degrees
  constexpr double spacing = pi / n_grid;
  constexpr int bits = std::numeric_limits<double>::digits / 2;
  double best = 0;
  for (unsigned int i = 1; i < n_grid; ++i)
    if (resistance.along(i * spacing) < resistance.along(best))
      best = i * spacing;
  const auto along = [&](const double angle) { return resistance.along(angle); };
  const double least =
      boost::math::tools::brent_find_minima(along, best - spacing, best + spacing, bits).second;
  return std::min(resistance.along(best), least);
}
} // namespace

double critical_friction_factor(const FrictionLaw &law, const Matrix3d &block)
{
  constexpr double quarter_turn = pi / 2;
  if (law.ellipse() == nullptr)
    return std::numeric_limits<double>::quiet_NaN();
  const SlipResistance resistance(*law.ellipse(), block);
  const bool is_x_held = block(0, 1) == 0 && block(1, 2) == 0;
  const bool is_y_held = block(0, 2) == 0 && block(1, 2) == 0;
  if ((is_x_held && is_y_held) || law.is_frictionless())
    return infinity;
  if (is_x_held)
    return resistance.along(quarter_turn);
  return is_y_held ? resistance.along(0) : least_over_directions(resistance);
}

CriticalFriction critical_friction(const ContactSystem &system)
{
  CriticalFriction critical;
  if (system.compliance().dense() == nullptr)
    critical.factor = std::numeric_limits<double>::quiet_NaN();
  for (Index node = 0; node < system.n_nodes(); ++node)
  {
    const double factor =
        critical_friction_factor(system.law(node), system.compliance().diagonal_block(node));
    if (factor < critical.factor || std::isnan(factor))
      critical = {factor, node};
  }
  return critical;
}
} // namespace orthocone
