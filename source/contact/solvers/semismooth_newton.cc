// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "loose_face.h"
#include "pressure_first_steps.h"
#include "proximal_steps.h"
#include "solvers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// Relaxation of the sweeps of a round. Where rounds keep stalling, exact sweeps send the forces to and fro
/// because single nodes have no solution or several (friction above the critical one, docs/theory.md, section
/// 8). Relaxed sweeps find a common solution.
double relaxation_of_round(const unsigned int round)
{
  constexpr unsigned int first_relaxed = 5;
  if (round < first_relaxed || round % 2 == 0)
    return 1;
  return round % 4 == 1 ? 0.3 : 0.05;
}

/// Forces that balance the load, and the motion of the face that brings the nodes back where they push them
/// off.
VectorXd pressed_start(const ContactStep &step)
{
  VectorXd unknowns = balancing_start(step);
  const NodeVector moved = step.displacement(unknowns);
  unknowns.tail(step.face().n()) -= step.face().columns().transpose() * moved;
  return unknowns;
}

/// Semismooth Newton on the natural map, with a line search that passes corners, and behind sweeps with one
/// that stops where steps no longer pay. Where a few nodes keep its steps short, they are solved by
/// themselves. Where it stalls, it falls back on exact sweeps, so that it inherits their robustness. Where W
/// is singular, some sweeps and then proximal steps come before.
class SemismoothNewton : public ContactSolver
{
public:
  /// What it does beside its own steps, or nothing of each.
  struct Help
  {
    std::unique_ptr<const HardestNodes> hardest_nodes{};
    std::unique_ptr<const ProximalSteps> proximal_steps{}; ///< for singular W
  };

  SemismoothNewton(const ContactSystem &system, const ContactSolverOptions &options, Help help);
  SemismoothNewton(const ContactSystem &system, const ContactSolverOptions &options)
      : SemismoothNewton(system, options, Help())
  {
  }

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  void iterate_while_it_pays(NewtonProgress &progress) const;
  void iterate_in_full(NewtonProgress &progress) const;
  void solve_singular(NewtonProgress &progress) const;
  bool run_round(unsigned int round, unsigned int n_sweeps, NewtonProgress &progress) const;

  ContactSolverOptions options_;
  GaussSeidel sweeps_;
  std::unique_ptr<ConditionSolver> conditions_;
  Help help_;
  PressureFirstSteps pressure_first_;
};

SemismoothNewton::SemismoothNewton(const ContactSystem &system, const ContactSolverOptions &options,
                                   Help help)
    : options_(options),
      sweeps_(system, options),
      conditions_(condition_solver(system, "newton")),
      help_(std::move(help)),
      pressure_first_(options, *conditions_, help_.hardest_nodes.get())
{
}

/// Newton's steps on the natural map, as long as each of them pays.
void SemismoothNewton::iterate_while_it_pays(NewtonProgress &progress) const
{
  constexpr unsigned int most_iterations = 12;
  constexpr double paying_reduction = 0.9; // sweeps pay more for the same gain (docs/performance.md)
  constexpr double smallest_step = 1. / 64;
  const ContactStep &step = progress.step;
  Iterate best(linearize, step, progress.unknowns, step.displacement(progress.unknowns), options_.rho_factor);
  // The error of the linearization would not do: its rho may be another one.
  const auto residual = [&] { return step.residual(best.unknowns, best.displacement); };
  progress.residual = residual();
  for (unsigned int i = 0; i < most_iterations && progress.iterations < options_.maximum_iterations; ++i)
  {
    progress.note(residual(), best.unknowns);
    if (progress.trace.points().back().residual <= options_.tolerance)
      break;
    const double last_error = best.linearization.error;
    const VectorXd change = newton_change(*conditions_, best.linearization, inexactness_of_newton);
    ++progress.iterations;
    if (!change.allFinite())
      break;
    Iterate next = line_search(linearize, step, best, change, smallest_step, options_.rho_factor);
    if (!(next.linearization.error < last_error))
      break;
    best = std::move(next);
    if (best.linearization.error > paying_reduction * last_error)
      break;
  }
  progress.offer(step.admissible(best.unknowns));
}

/// Takes Newton's steps on the natural map in full, whatever the residual does on the way: where pieces of
/// the map meet, line searches may stop at a corner that full steps pass.
void SemismoothNewton::iterate_in_full(NewtonProgress &progress) const
{
  constexpr unsigned int most_iterations = 15;
  const ContactStep &step = progress.step;
  VectorXd trial = progress.unknowns;
  for (unsigned int i = 0; i < most_iterations && progress.iterations < options_.maximum_iterations &&
                           progress.residual > options_.tolerance;
       ++i)
  {
    const auto linearization = linearize(step, trial, step.displacement(trial), options_.rho_factor);
    const VectorXd change = newton_change(*conditions_, linearization, inexactness_of_stalled_newton);
    trial += change; // may leave the cone on the way
    ++progress.iterations;
    if (!trial.allFinite())
      break;
    progress.offer(step.admissible(trial));
  }
}

/// Proximal steps, unless sweeps do, which is so for few bodies or good starts. With a hundred nodes all of
/// the sweeps cost as much as four of Newton's steps, and with a sparse W five times as many do. They end
/// where twice as many would not do.
void SemismoothNewton::solve_singular(NewtonProgress &progress) const
{
  constexpr unsigned int interval = 20;
  const ContactStep &step = progress.step;
  const unsigned int most_sweeps = step.system().compliance().is_sparse() ? 2000 : 400;
  VectorXd swept = progress.unknowns, improved = progress.unknowns;
  bool is_promising = true;
  for (unsigned int n = interval;
       is_promising && progress.residual > options_.tolerance && n <= most_sweeps &&
       progress.iterations + interval <= options_.maximum_iterations;
       n += interval)
  {
    const double last = progress.residual;
    for (unsigned int i = 0; i < interval; ++i, ++progress.iterations)
      sweeps_.sweep(step, swept, 1);
    progress.offer(swept);
    const double pace = progress.residual / last, looks = 2. * (most_sweeps - n) / interval;
    is_promising = progress.residual * std::pow(pace, looks) <= options_.tolerance;
  }
  if (progress.residual <= options_.tolerance)
    return;
  progress.iterations +=
      help_.proximal_steps->improve(step, improved, options_.maximum_iterations - progress.iterations);
  progress.offer(step.admissible(std::move(improved)));
}

/// Runs sweeps, then Newton's steps with each line search. Returns whether the face runs away.
bool SemismoothNewton::run_round(const unsigned int round, const unsigned int n_sweeps,
                                 NewtonProgress &progress) const
{
  for (unsigned int i = 0; i < n_sweeps && progress.iterations < options_.maximum_iterations;
       ++i, ++progress.iterations)
    sweeps_.sweep(progress.step, progress.unknowns, relaxation_of_round(round));
  if (round == 0)
  {
    pressure_first_.iterate(progress); // sweeps only after stalls (docs/performance.md)
    if (progress.residual <= options_.tolerance)
      return false;
  }
  iterate_while_it_pays(progress);
  if (round > 0 && progress.residual > options_.tolerance)
  {
    pressure_first_.iterate(progress);
    iterate_in_full(progress);
  }
  return progress.residual > options_.tolerance &&
         progress.balance.runs_away(progress.step, progress.unknowns);
}

SolverReport SemismoothNewton::solve(const ContactStep &step, VectorXd &unknowns) const
{
  constexpr unsigned int first_sweeps = 10; // then twice as many each time: docs/theory.md, section 3
  constexpr unsigned int most_sweeps = 160;
  const VectorXd start = unknowns;
  const double start_residual = step.residual(start);
  NewtonProgress progress{step, unknowns, start_residual};
  progress.note(progress.residual, unknowns);
  const bool is_rigid = help_.proximal_steps && help_.proximal_steps->are_needed_by_few_nodes();
  if (is_loose_without_forces(step, unknowns) && progress.residual > options_.tolerance)
  {
    unknowns = pressed_start(step);
    progress.residual = step.residual(unknowns);
  }
  if (is_rigid)
    solve_singular(progress);
  unsigned int n_sweeps = 0;
  for (unsigned int round = 0;
       progress.residual > options_.tolerance && progress.iterations < options_.maximum_iterations &&
       std::isfinite(progress.residual);
       ++round)
  {
    if (round == 1)
    {
      // Sweeps from where Newton's steps stalled may lead to another solution than sweeps from the start, and
      // the next load step may have none behind it (docs/stability.md).
      unknowns = start;
      progress.residual = start_residual;
      if (!is_rigid && help_.proximal_steps && help_.proximal_steps->are_needed())
        solve_singular(progress);
      if (progress.residual <= options_.tolerance)
        break;
    }
    if (run_round(round, n_sweeps, progress))
      return unbalanced_report(step, unknowns, progress.iterations, options_.tolerance,
                               std::move(progress.trace));
    n_sweeps = std::clamp(2 * n_sweeps, first_sweeps, most_sweeps);
  }
  return make_report(step, unknowns, progress.iterations, options_.tolerance, std::move(progress.trace));
}

std::unique_ptr<ContactSolver> make_newton(const ContactSystem &system, const ContactSolverOptions &options)
{
  if (system.compliance().dense() == nullptr)
    return make_continuation(system, options);
  SemismoothNewton::Help help{std::make_unique<HardestNodes>(options, make<SemismoothNewton>),
                              std::make_unique<ProximalSteps>(system, options, make<SemismoothNewton>)};
  return std::make_unique<SemismoothNewton>(system, options, std::move(help));
}
} // namespace

ContactMethod newton_method()
{
  ContactMethod method{"newton", "semismooth Newton between exact sweeps", make_newton};
  method.needs_dense = false;
  method.rho = "1 / the largest diagonal entry of a node's compliance";
  return method;
}
} // namespace orthocone
