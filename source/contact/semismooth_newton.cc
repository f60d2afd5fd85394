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
/// Forces, their displacement and what the natural map says there.
struct Iterate
{
  Iterate(const ContactProblem &problem, NodeVector force_, NodeVector displacement_, const double rho_factor)
      : force(std::move(force_)),
        displacement(std::move(displacement_)),
        system(problem, force, displacement, rho_factor)
  {
  }

  NodeVector force;
  NodeVector displacement;
  NewtonSystem system;
};

/// The first of the iterates along `change`, each half as far as the one before, that makes the natural map
/// smaller; nothing if none does. W is linear, so that they cost no product with it.
std::optional<Iterate> line_search(const ContactProblem &problem, const Iterate &start,
                                   const NodeVector &change, const double rho_factor)
{
  constexpr double sufficient_decrease = 1e-4;
  constexpr double smallest_step = 1. / 64;
  NodeVector moved;
  problem.compliance().vmult(moved, change);
  for (double step = 1; step >= smallest_step; step /= 2)
  {
    Iterate trial(problem, start.force + step * change, start.displacement + step * moved, rho_factor);
    if (trial.system.error() <= (1 - sufficient_decrease * step) * start.system.error())
      return trial;
  }
  return std::nullopt;
}

/// Relaxation of the sweeps of a round. Where rounds keep stalling, exact sweeps send the forces to and fro,
/// as single nodes have no solution or several (friction above the critical one): relaxed ones find a common
/// solution.
double relaxation_of_round(const unsigned int round)
{
  constexpr unsigned int first_relaxed = 5;
  if (round < first_relaxed || round % 2 == 0)
    return 1;
  return round % 4 == 1 ? 0.3 : 0.05;
}
} // namespace

SemismoothNewton::SemismoothNewton(const ContactProblem &problem, const ContactSolverOptions &options)
    : problem_(problem),
      options_(options),
      sweeps_(problem, options),
      inner_(dense_compliance(problem, "newton"), problem.largest_compliance())
{
}

/// Newton iterations while each of them pays. Leaves the best forces and returns their residual.
double SemismoothNewton::iterate_while_it_pays(NodeVector &force, unsigned int &iterations,
                                               Trace &trace) const
{
  constexpr unsigned int most_iterations = 12;
  constexpr double paying_reduction = 0.7; // a sweep costs far less than an iteration that gains less
  constexpr float inexactness = 0.01F;     // tighter costs more products than it saves iterations
  Iterate best(problem_, force, problem_.displacement(force), options_.rho_factor);
  // Not the error of the system, whose rho may be another one.
  const auto residual = [&] { return problem_.residual(best.force, best.displacement); };
  const double first_residual = residual();
  for (unsigned int i = 0; i < most_iterations && iterations < options_.maximum_iterations; ++i)
  {
    trace.add(iterations, residual(), problem_.force_scale(best.force));
    if (trace.points().back().residual <= options_.tolerance)
      break;
    const double last_error = best.system.error();
    const NodeVector change = best.system.solve(inner_, inexactness);
    ++iterations;
    if (!change.allFinite())
      break;
    auto next = line_search(problem_, best, change, options_.rho_factor);
    if (!next)
      break;
    best = std::move(*next);
    if (best.system.error() > paying_reduction * last_error)
      break;
  }
  const NodeVector candidate = problem_.admissible(best.force);
  const double last_residual = problem_.residual(candidate);
  if (!(last_residual < first_residual))
    return first_residual;
  force = candidate;
  return last_residual;
}

/// Newton's steps in full from `trial` on, whatever the residual does on the way: where pieces of the natural
/// map meet, the line search may stop at a corner that full steps pass over. Leaves the best forces and
/// returns their residual.
double SemismoothNewton::iterate_in_full(NodeVector trial, double least, NodeVector &force,
                                         unsigned int &iterations, Trace &trace) const
{
  constexpr unsigned int most_iterations = 15;
  constexpr float inexactness = 1e-4F; // what single precision gives without trouble
  for (unsigned int i = 0; i < most_iterations && iterations < options_.maximum_iterations; ++i, ++iterations)
  {
    const NewtonSystem system(problem_, trial, problem_.displacement(trial), options_.rho_factor);
    trial += system.solve(inner_, inexactness); // may leave the cone on the way
    const NodeVector candidate = problem_.admissible(trial);
    const double residual = problem_.residual(candidate);
    if (!std::isfinite(residual))
      break;
    if (residual < least)
    {
      least = residual;
      force = candidate;
      trace.add(iterations, residual, problem_.force_scale(force));
    }
    if (residual <= options_.tolerance)
      break;
  }
  return least;
}

SolverReport SemismoothNewton::solve(NodeVector &force)
{
  constexpr unsigned int first_sweeps = 10;
  constexpr unsigned int most_sweeps = 160;
  constexpr unsigned int first_full_round = 2; // where line search and sweeps have stalled twice
  constexpr double good_start = 0.1;           // sweeps are for starts that are farther off, and for stalls
  unsigned int iterations = 0;
  Trace trace;
  const NodeVector start = force;
  double residual = problem_.residual(force);
  trace.add(iterations, residual, problem_.force_scale(force));
  unsigned int n_sweeps = residual > good_start ? first_sweeps : 0;
  for (unsigned int round = 0;
       residual > options_.tolerance && iterations < options_.maximum_iterations && std::isfinite(residual);
       ++round)
  {
    for (unsigned int i = 0; i < n_sweeps && iterations < options_.maximum_iterations; ++i, ++iterations)
      sweeps_.sweep(force, relaxation_of_round(round));
    residual = iterate_while_it_pays(force, iterations, trace);
    if (round >= first_full_round && residual > options_.tolerance)
      residual =
          iterate_in_full(round == first_full_round ? start : force, residual, force, iterations, trace);
    n_sweeps = std::clamp(2 * n_sweeps, first_sweeps, most_sweeps);
  }
  return make_report(problem_, force, iterations, options_.tolerance, std::move(trace));
}
} // namespace orthocone
