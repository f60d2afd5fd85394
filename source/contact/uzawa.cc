// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solvers.h"

#include <algorithm>
#include <cmath>

namespace orthocone
{
using Eigen::Index;

Uzawa::Uzawa(const ContactProblem &problem, const ContactSolverOptions &options)
    : problem_(problem),
      options_(options),
      rho_(3 * problem.n_nodes())
{
  for (Index node = 0; node < problem.n_nodes(); ++node)
    rho_.segment<3>(3 * node).setConstant(problem.rho(node));
}

NodeVector Uzawa::modified(const NodeVector &force) const
{
  NodeVector g = problem_.displacement(force);
  for (Index node = 0; node < problem_.n_nodes(); ++node)
    g.segment<3>(3 * node) = modified_displacement(problem_.law(node), g.segment<3>(3 * node));
  return g;
}

NodeVector Uzawa::predicted(const NodeVector &force, const NodeVector &direction, const double factor) const
{
  NodeVector moved = force - factor * rho_.cwiseProduct(direction);
  for (Index node = 0; node < problem_.n_nodes(); ++node)
    moved.segment<3>(3 * node) = project(problem_.law(node), moved.segment<3>(3 * node));
  return moved;
}

/// One prediction and one correction.
void Uzawa::iterate(NodeVector &force, double &factor) const
{
  // Values that He and Liao recommend: the prediction is accepted while `ratio` <= largest_ratio, and the
  // step grows when it was far too careful.
  constexpr double largest_ratio = 0.9;
  constexpr double careful_ratio = 0.5;
  constexpr double growth = 1.5;
  constexpr double over_relaxation = 1.9;
  constexpr unsigned int most_reductions = 60;

  const NodeVector g = modified(force);
  NodeVector prediction, change, g_predicted, g_change;
  double ratio = 0;
  for (unsigned int reduction = 0; reduction < most_reductions; ++reduction)
  {
    prediction = predicted(force, g, factor);
    change = force - prediction;
    g_predicted = modified(prediction);
    g_change = factor * rho_.cwiseProduct(g - g_predicted);
    const double size = std::sqrt((change.array().square() / rho_.array()).sum());
    if (size == 0)
      return;
    ratio = std::sqrt((g_change.array().square() / rho_.array()).sum()) / size;
    if (ratio <= largest_ratio)
      break;
    factor *= 2. / 3 * std::min(1., 1 / ratio);
  }
  const NodeVector descent = change - g_change;
  const double length = (change.array() * descent.array() / rho_.array()).sum() /
                        (descent.array().square() / rho_.array()).sum();
  force = predicted(force, g_predicted, over_relaxation * length * factor);
  if (ratio <= careful_ratio)
    factor *= growth;
}

SolverReport Uzawa::solve(NodeVector &force)
{
  constexpr unsigned int iterations_between_checks = 10;
  // Nothing is kept from one load step to the next: a resumed run must go the same way.
  double factor = 1 / (problem_.largest_compliance() * rho_.maxCoeff());
  return iterate_until_converged(problem_, options_, iterations_between_checks, force,
                                 [&](NodeVector &r) { iterate(r, factor); });
}
} // namespace orthocone
