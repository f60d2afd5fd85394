// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/law/law_path.h>

#include <orthocone/base/numbers.h>
#include <orthocone/contact/law/rosette.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace orthocone
{
using Eigen::Vector2d;

namespace
{
FrictionLaw ellipses_on_path(const OrthotropicFriction &law, const double t)
{
  const Vector2d mu = law.mu(), p = law.p();
  const double ratio = std::pow(p[0] / p[1], t) * std::pow(mu[0] / mu[1], 1 - t);
  return OrthotropicFriction{mu[0], mu[1], mu[0], mu[0] / ratio};
}

/// With c = b - a the force leans from e(a) by t c. Its turn 1 - t + t b' is positive, the leaning is less
/// than a right angle, and kappa/R = (1 - t + t b') cos(t c) + t (ln R)' sin(t c) is at least (1 - t) cos(t
/// c)
/// + t b' sin((1 - t) c)/sin(c), because kappa > 0 for t = 1: all three conditions hold on the way.
FrictionLaw table_on_path(const FrictionLaw &law, const double t)
{
  constexpr unsigned int n_directions = 72;
  std::vector<Rosette::Row> rows;
  for (unsigned int i = 0; i < n_directions; ++i)
  {
    const double a = 2 * pi * i / n_directions;
    const Vector2d e(std::cos(a), std::sin(a)), to_the_left(-e[1], e[0]), f = law.force_against(-e);
    const double lean = t * std::atan2(f.dot(to_the_left), f.dot(e));
    const double size = std::pow(f.norm(), t) * std::pow(law.mean_friction(), 1 - t);
    rows.push_back({a, size * std::cos(lean), size * std::sin(lean)});
  }
  return FrictionLaw(std::make_shared<const Rosette>(std::move(rows)));
}
} // namespace

bool has_easier_law(const FrictionLaw &law)
{
  constexpr double rounding = 1e-12;
  const auto is_one = [](const double ratio) { return ratio - 1 <= rounding; };
  const bool has_one_weight = is_one(std::sqrt(law.slip_amplification()));
  if (law.ellipse() != nullptr)
    return !has_one_weight;
  return !has_one_weight || !is_one(law.largest_friction() / law.least_friction());
}

FrictionLaw law_on_path(const FrictionLaw &law, const double t)
{
  if (law.is_frictionless() || !has_easier_law(law))
    return law;
  if (law.ellipse() != nullptr)
    return ellipses_on_path(*law.ellipse(), t);
  try
  {
    return table_on_path(law, t);
  }
  catch (const std::invalid_argument &)
  {
    return law;
  }
}
} // namespace orthocone
