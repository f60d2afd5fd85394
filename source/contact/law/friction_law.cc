// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/law/friction_law.h>

#include <orthocone/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace orthocone
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace
{
/// Throws std::invalid_argument unless a map and its inverse have brought a direction back to itself.
void require_inverse(const std::string &of, const Vector2d &image, const Vector2d &direction)
{
  constexpr double close = 1e-8;           // maps without formulas are inverted by iterations
  if ((image - direction).norm() <= close) // not for NaN
    return;
  throw std::invalid_argument("friction law: the maps of " + of +
                              " are not inverse to each other at the reduced " + of + " (" +
                              std::to_string(direction[0]) + ", " + std::to_string(direction[1]) + ")");
}
} // namespace

FrictionLaw::FrictionLaw(const OrthotropicFriction &ellipse)
    : ellipse_(ellipse)
{
  if (orthocone::is_frictionless(ellipse))
    return;
  mu_ = ellipse.mu();
  // The longer axis of the slip ellipse has the weight 1/mu: the law does not depend on the length of p.
  const Vector2d p = ellipse.p() / ellipse.p().maxCoeff();
  slip_ = p.cwiseProduct(p).cwiseQuotient(mu_);
  mean_friction_ = std::sqrt(mu_[0] * mu_[1]);
  least_friction_ = mu_.minCoeff();
  largest_friction_ = mu_.maxCoeff();
  const double ratio = (ellipse.p_x / ellipse.mu_x) / (ellipse.p_y / ellipse.mu_y);
  slip_amplification_ = std::max(ratio, 1 / ratio) * std::max(ratio, 1 / ratio);
}

// Without formulas for its mean and extremes, a law is looked at in so many directions: what depends on them
// are scales and tolerances, and no solution.
FrictionLaw::FrictionLaw(std::shared_ptr<const TangentMaps> maps)
    : maps_(std::move(maps))
{
  constexpr unsigned int n_directions = 360;
  double sum = 0, largest_weight = 0;
  double least_weight = least_friction_ = std::numeric_limits<double>::infinity();
  for (unsigned int i = 0; i < n_directions; ++i)
  {
    const double angle = 2 * pi * i / n_directions;
    const Vector2d e(std::cos(angle), std::sin(angle));
    const double friction = maps_->force(e).norm();
    const double weight = maps_->reduced_force(maps_->reduced_slip(e)).norm();
    require_inverse("force", maps_->reduced_force(maps_->force(e)), e);
    require_inverse("slip", maps_->reduced_slip(maps_->slip(e)), e);
    sum += std::log(friction);
    least_friction_ = std::min(least_friction_, friction);
    largest_friction_ = std::max(largest_friction_, friction);
    least_weight = std::min(least_weight, weight);
    largest_weight = std::max(largest_weight, weight);
  }
  mean_friction_ = std::exp(sum / n_directions);
  slip_amplification_ = largest_weight / least_weight;
}

// The size of the reduced slip is free: it is divided by the factor, as that of an ellipse is by mu.
FrictionLaw FrictionLaw::scaled(const double factor) const
{
  if (!maps_)
    return OrthotropicFriction{factor * ellipse_.mu_x, factor * ellipse_.mu_y, ellipse_.p_x, ellipse_.p_y};
  FrictionLaw law = *this;
  law.factor_ *= factor;
  law.mean_friction_ *= factor;
  law.least_friction_ *= factor;
  law.largest_friction_ *= factor;
  return law;
}

Matrix2d FrictionLaw::force_derivative(const Vector2d &force) const
{
  return maps_ ? Matrix2d(factor_ * maps_->reduced_force_derivative(force).inverse())
               : Matrix2d(mu_.asDiagonal());
}

Matrix2d FrictionLaw::reduced_slip_derivative(const Vector2d &slip) const
{
  return maps_ ? Matrix2d(maps_->reduced_slip_derivative(slip) / factor_) : Matrix2d(slip_.asDiagonal());
}

double FrictionLaw::load(const Vector2d &force) const
{
  if (is_frictionless())
    return force.isZero(0) ? 0 : std::numeric_limits<double>::infinity();
  const Vector2d reduced = reduced_force(force);
  return std::hypot(reduced[0], reduced[1]);
}

Vector2d FrictionLaw::force_against(const Vector2d &direction) const
{
  return force(-reduced_slip(direction).stableNormalized());
}

Vector2d FrictionLaw::slip_under(const Vector2d &force) const
{
  return slip(-reduced_force(force));
}

// The gradient of |r'|^2 / 2.
Vector2d FrictionLaw::cone_normal(const Vector2d &force) const
{
  return force_derivative(force).inverse().transpose() * reduced_force(force);
}

} // namespace orthocone
