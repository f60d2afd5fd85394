// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "newton_system.h"
#include "solvers.h"

#include <algorithm>
#include <optional>
#include <utility>

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

/// Forces, their displacement and what the natural map says there.
struct Iterate
{
  Iterate(const ContactProblem &problem, NodeVector force_, NodeVector displacement_)
      : force(std::move(force_)),
        displacement(std::move(displacement_)),
        system(problem, force, displacement)
  {
  }

  NodeVector force;
  NodeVector displacement;
  NewtonSystem system;
};

/// The first of the iterates along `change`, each half as far as the one before, that makes the natural map
/// smaller; nothing if none does. W is linear, so that they cost no product with it.
std::optional<Iterate> line_search(const ContactProblem &problem, const Iterate &start,
                                   const NodeVector &change)
{
  constexpr double sufficient_decrease = 1e-4;
  constexpr double smallest_step = 1. / 64;
  NodeVector moved;
  problem.compliance().vmult(moved, change);
  for (double step = 1; step >= smallest_step; step /= 2)
  {
    Iterate trial(problem, start.force + step * change, start.displacement + step * moved);
    if (trial.system.error() <= (1 - sufficient_decrease * step) * start.system.error())
      return trial;
  }
  return std::nullopt;
}

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
      sweeps_(problem, unrelaxed(options)),
      inner_(dense_compliance(problem, "newton"), problem.largest_compliance())
{
}

/// Newton iterations while each of them pays. Leaves the best forces and returns their residual.
double SemismoothNewton::iterate_while_it_pays(NodeVector &force, unsigned int &iterations) const
{
  constexpr unsigned int most_iterations = 12;
  constexpr double paying_reduction = 0.7; // a sweep costs far less than an iteration that gains less
  constexpr float inexactness = 0.01F;     // tighter costs more products than it saves iterations
  Iterate best(problem_, force, problem_.displacement(force));
  const auto residual = [&] { return best.system.error() / problem_.force_scale(best.force); };
  const double first_residual = residual();
  for (unsigned int i = 0; i < most_iterations && iterations < options_.maximum_iterations; ++i)
  {
    if (residual() <= options_.tolerance)
      break;
    const double last_error = best.system.error();
    const NodeVector change = best.system.solve(inner_, inexactness);
    ++iterations;
    if (!change.allFinite())
      break;
    auto next = line_search(problem_, best, change);
    if (!next)
      break;
    best = std::move(*next);
    if (best.system.error() > paying_reduction * last_error)
      break;
  }
  const NodeVector candidate = admissible(problem_, best.force);
  const double last_residual = problem_.residual(candidate);
  if (!(last_residual < first_residual))
    return first_residual;
  force = candidate;
  return last_residual;
}

SolverReport SemismoothNewton::solve(NodeVector &force)
{
  constexpr unsigned int first_sweeps = 10;
  constexpr unsigned int most_sweeps = 160;
  constexpr double good_start = 0.1; // sweeps are for starts that are farther off, and for stalls
  unsigned int iterations = 0;
  double residual = problem_.residual(force);
  unsigned int n_sweeps = residual > good_start ? first_sweeps : 0;
  while (residual > options_.tolerance && iterations < options_.maximum_iterations && std::isfinite(residual))
  {
    for (unsigned int i = 0; i < n_sweeps && iterations < options_.maximum_iterations; ++i, ++iterations)
      sweeps_.sweep(force);
    residual = iterate_while_it_pays(force, iterations);
    n_sweeps = std::clamp(2 * n_sweeps, first_sweeps, most_sweeps);
  }
  return make_report(problem_, force, iterations, options_.tolerance);
}
} // namespace orthocone
