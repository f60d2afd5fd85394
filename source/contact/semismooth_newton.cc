// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "newton_system.h"
#include "solvers.h"

#include <algorithm>

namespace orthocone
{
namespace
{
/// Forces moved into the cone, where the law wants them.
NodeVector admissible(const ContactProblem &problem, NodeVector force)
{
  for (Eigen::Index node = 0; node < problem.n_nodes(); ++node)
    force.segment<3>(3 * node) = project(problem.law(node), force.segment<3>(3 * node));
  return force;
}

/// Best of the trial forces along a Newton direction. W is linear, so that a trial costs no product with it.
struct LineSearch
{
  NodeVector force;
  NodeVector displacement;
  double error; ///< norm of the natural map

  /// Halves the step until the natural map gets smaller; false if it never does.
  bool advance(const ContactProblem &problem, const NodeVector &change)
  {
    constexpr double sufficient_decrease = 1e-4;
    constexpr double smallest_step = 1. / 64;
    NodeVector moved;
    problem.compliance().vmult(moved, change);
    for (double step = 1; step >= smallest_step; step /= 2)
    {
      NodeVector trial = force + step * change;
      NodeVector trial_displacement = displacement + step * moved;
      const double trial_error = problem.natural_map(trial, trial_displacement).norm();
      if (trial_error <= (1 - sufficient_decrease * step) * error)
      {
        force.swap(trial);
        displacement.swap(trial_displacement);
        error = trial_error;
        return true;
      }
    }
    return false;
  }
};
/// The relaxation factor is for the sweeps as a method of their own.
ContactSolverOptions unrelaxed(ContactSolverOptions options)
{
  options.relaxation = 1;
  return options;
}
} // namespace

SemismoothNewton::SemismoothNewton(const ContactProblem &problem, const ContactSolverOptions &options)
    : problem_(problem),
      options_(options),
      sweeps_(problem, unrelaxed(options))
{
}

/// Newton iterations while each of them pays. Leaves the best forces.
void SemismoothNewton::iterate_while_it_pays(NodeVector &force, unsigned int &iterations) const
{
  constexpr unsigned int most_iterations = 12;
  constexpr double paying_reduction =
      0.7; // a sweep costs far less than an iteration that gains less than this
  LineSearch search{force, problem_.displacement(force), 0};
  search.error = problem_.natural_map(search.force, search.displacement).norm();
  for (unsigned int i = 0; i < most_iterations && iterations < options_.maximum_iterations; ++i)
  {
    const double last_error = search.error;
    const NodeVector change = NewtonSystem(problem_, search.force, search.displacement).solve();
    ++iterations;
    if (!change.allFinite() || !search.advance(problem_, change))
      break;
    const NodeVector candidate = admissible(problem_, search.force);
    if (problem_.residual(candidate) <= options_.tolerance)
    {
      force = candidate;
      return;
    }
    if (search.error > paying_reduction * last_error)
      break;
  }
  const NodeVector candidate = admissible(problem_, search.force);
  if (problem_.residual(candidate) < problem_.residual(force))
    force = candidate;
}

SolverReport SemismoothNewton::solve(NodeVector &force)
{
  constexpr unsigned int first_sweeps = 10;
  constexpr unsigned int most_sweeps = 160;
  unsigned int n_sweeps = first_sweeps;
  unsigned int iterations = 0;
  double residual = problem_.residual(force);
  while (residual > options_.tolerance && iterations < options_.maximum_iterations && std::isfinite(residual))
  {
    for (unsigned int i = 0; i < n_sweeps && iterations < options_.maximum_iterations; ++i, ++iterations)
      sweeps_.sweep(force);
    if (problem_.residual(force) > options_.tolerance)
      iterate_while_it_pays(force, iterations);
    residual = problem_.residual(force);
    n_sweeps = std::min(2 * n_sweeps, most_sweeps);
  }
  return make_report(problem_, force, iterations, options_.tolerance);
}
} // namespace orthocone
