// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "newton_steps.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace orthocone
{
using Eigen::VectorXd;

Iterate::Iterate(Map *const map, const ContactStep &step, VectorXd unknowns_, NodeVector displacement_,
                 BodyPart body_, const double rho_factor)
    : unknowns(std::move(unknowns_)),
      displacement(std::move(displacement_)),
      body(std::move(body_)),
      linearization(map(step, unknowns, displacement, rho_factor)),
      body_residual(step.system().compliance().norm(body.residual)),
      error(std::hypot(linearization.error, body_residual))
{
  linearization.conditions.residual = body.residual;
}

Iterate NewtonSteps::at(const ContactStep &step, const VectorXd &unknowns) const
{
  return {map_, step, unknowns, step.displacement(unknowns), {}, rho_factor_};
}

Iterate NewtonSteps::approximately_at(const ContactStep &step, const VectorXd &unknowns) const
{
  ContactChange known = step.approximate(unknowns);
  return {map_, step, unknowns, std::move(known.displacement), std::move(known.body), rho_factor_};
}

ContactChange NewtonSteps::change(const ContactStep &step, const Iterate &from, const double accuracy) const
{
  return with_displacement(step, conditions_.solve(from.linearization.conditions, accuracy));
}

Iterate NewtonSteps::behind(const ContactStep &step, const Iterate &from, const ContactChange &change,
                            const double length) const
{
  return {map_,
          step,
          from.unknowns + length * unknowns_of(change),
          from.displacement + length * change.displacement,
          from.body.moved(length, change.body),
          rho_factor_};
}

/// Armijo's rule: a length s is low enough if the error behind it is at most (1 - c s) times the bound. The
/// bound is the last error, or a larger one where the error may rise for a while (Globalization).
Iterate NewtonSteps::search(const ContactStep &step, const Iterate &from, const ContactChange &change,
                            const LineSearch &line_search) const
{
  constexpr double sufficient_decrease = 1e-4, bearable_growth = 1.2, bearable_leap = 10;
  const auto is_low = [&](const Iterate &tried, const double length)
  { return tried.error <= (1 - sufficient_decrease * length) * line_search.bound; };
  Iterate full = behind(step, from, change, 1);
  if (is_low(full, 1))
    return full;
  const bool may_leap = line_search.leaps != nullptr && *line_search.leaps > 0 &&
                        full.error <= bearable_leap * line_search.bound;
  std::optional<Iterate> best;
  for (double length = 0.5; length >= line_search.shortest_length; length /= 2)
  {
    Iterate tried = behind(step, from, change, length);
    if (is_low(tried, length))
      return tried;
    if (may_leap)
    {
      --*line_search.leaps;
      return full;
    }
    if (!best || tried.error < best->error || line_search.fallback == LineSearch::Fallback::shortest)
      best = std::move(tried);
  }
  const bool is_bearable = best->error <= std::min(full.error, bearable_growth * from.error);
  return line_search.fallback == LineSearch::Fallback::shortest || is_bearable ? *std::move(best) : full;
}
} // namespace orthocone
