// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "linearization.h"
#include "solvers.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// Unknowns, their displacement, and the natural map there.
struct Iterate
{
  Iterate(const ContactStep &step, VectorXd unknowns_, NodeVector displacement_, const double rho_factor)
      : unknowns(std::move(unknowns_)),
        displacement(std::move(displacement_)),
        linearization(linearize(step, unknowns, displacement, rho_factor))
  {
  }

  VectorXd unknowns;
  NodeVector displacement;
  Linearization linearization;
};

/// The first of the iterates along `change`, each half as far as the one before, that reduces the natural
/// map; nothing if none does. Since W is linear, they cost no product with it.
std::optional<Iterate> line_search(const ContactStep &step, const Iterate &start, const VectorXd &change,
                                   const double rho_factor)
{
  constexpr double sufficient_decrease = 1e-4;
  constexpr double smallest_step = 1. / 64;
  const NodeVector moved = step.change_of_displacement(change);
  for (double length = 1; length >= smallest_step; length /= 2)
  {
    Iterate trial(step, start.unknowns + length * change, start.displacement + length * moved, rho_factor);
    if (trial.linearization.error <= (1 - sufficient_decrease * length) * start.linearization.error)
      return trial;
  }
  return std::nullopt;
}

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

/// Semismooth Newton on the natural map with a backtracking line search. Exact sweeps start it, and it
/// returns to them from the best iterate whenever it stalls, so that it inherits their robustness.
class SemismoothNewton : public ContactSolver
{
public:
  SemismoothNewton(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  /// A step on the way to its solution.
  struct Progress;

  void iterate_while_it_pays(Progress &progress) const;
  void iterate_in_full(Eigen::VectorXd trial, Progress &progress) const;
  bool run_round(unsigned int round, unsigned int n_sweeps, Progress &progress) const;

  ContactSolverOptions options_;
  GaussSeidel sweeps_;
  std::unique_ptr<ConditionSolver> conditions_;
};

struct SemismoothNewton::Progress
{
  const ContactStep &step;
  const VectorXd start;
  VectorXd &unknowns; ///< the best so far
  double residual;    ///< of them
  unsigned int iterations = 0;
  Trace trace{};
  BalanceWatch balance{};

  void note(const double residual_, const VectorXd &unknowns_)
  {
    trace.add(iterations, residual_, step.force_scale(unknowns_));
  }
};

SemismoothNewton::SemismoothNewton(const ContactSystem &system, const ContactSolverOptions &options)
    : options_(options),
      sweeps_(system, options),
      conditions_(condition_solver(system, "newton"))
{
}

/// Newton iterations, as long as each of them pays.
void SemismoothNewton::iterate_while_it_pays(Progress &progress) const
{
  constexpr unsigned int most_iterations = 12;
  constexpr double paying_reduction = 0.9; // sweeps pay more for the same gain (docs/performance.md)
  constexpr double inexactness = 0.01;     // tighter costs more products than it saves iterations
  const ContactStep &step = progress.step;
  Iterate best(step, progress.unknowns, step.displacement(progress.unknowns), options_.rho_factor);
  // The error of the linearization would not do: its rho may be another one.
  const auto residual = [&] { return step.residual(best.unknowns, best.displacement); };
  progress.residual = residual();
  for (unsigned int i = 0; i < most_iterations && progress.iterations < options_.maximum_iterations; ++i)
  {
    progress.note(residual(), best.unknowns);
    if (progress.trace.points().back().residual <= options_.tolerance)
      break;
    const double last_error = best.linearization.error;
    const VectorXd change = newton_change(*conditions_, best.linearization, inexactness);
    ++progress.iterations;
    if (!change.allFinite())
      break;
    auto next = line_search(step, best, change, options_.rho_factor);
    if (!next)
      break;
    best = std::move(*next);
    if (best.linearization.error > paying_reduction * last_error)
      break;
  }
  const VectorXd candidate = step.admissible(best.unknowns);
  if (const double last = step.residual(candidate); last < progress.residual)
  {
    progress.unknowns = candidate;
    progress.residual = last;
  }
}

/// Takes Newton's steps in full from `trial` on, whatever the residual does on the way: where pieces of the
/// natural map meet, the line search may stop at a corner that full steps pass.
void SemismoothNewton::iterate_in_full(VectorXd trial, Progress &progress) const
{
  constexpr unsigned int most_iterations = 15;
  constexpr double inexactness = 1e-4; // what single precision gives without trouble
  const ContactStep &step = progress.step;
  for (unsigned int i = 0; i < most_iterations && progress.iterations < options_.maximum_iterations;
       ++i, ++progress.iterations)
  {
    const auto linearization = linearize(step, trial, step.displacement(trial), options_.rho_factor);
    trial += newton_change(*conditions_, linearization, inexactness); // may leave the cone on the way
    const VectorXd candidate = step.admissible(trial);
    const double residual = step.residual(candidate);
    if (!std::isfinite(residual))
      break;
    if (residual < progress.residual)
    {
      progress.residual = residual;
      progress.unknowns = candidate;
      progress.note(residual, candidate);
    }
    if (residual <= options_.tolerance)
      break;
  }
}

/// Runs sweeps, then Newton's steps. Returns whether the face runs away.
bool SemismoothNewton::run_round(const unsigned int round, const unsigned int n_sweeps,
                                 Progress &progress) const
{
  constexpr unsigned int first_full_round = 2; // line search and sweeps have stalled twice by then
  for (unsigned int i = 0; i < n_sweeps && progress.iterations < options_.maximum_iterations;
       ++i, ++progress.iterations)
    sweeps_.sweep(progress.step, progress.unknowns, relaxation_of_round(round));
  iterate_while_it_pays(progress);
  if (round >= first_full_round && progress.residual > options_.tolerance)
    iterate_in_full(round == first_full_round ? progress.start : progress.unknowns, progress);
  return progress.residual > options_.tolerance &&
         progress.balance.runs_away(progress.step, progress.unknowns);
}

SolverReport SemismoothNewton::solve(const ContactStep &step, VectorXd &unknowns) const
{
  constexpr unsigned int first_sweeps = 10; // then twice as many each time: docs/theory.md, section 3
  constexpr unsigned int most_sweeps = 160;
  constexpr double good_start = 0.1; // sweeps are for worse starts, and for stalls
  Progress progress{step, unknowns, unknowns, step.residual(unknowns)};
  progress.note(progress.residual, unknowns);
  unsigned int n_sweeps = progress.residual > good_start ? first_sweeps : 0;
  for (unsigned int round = 0;
       progress.residual > options_.tolerance && progress.iterations < options_.maximum_iterations &&
       std::isfinite(progress.residual);
       ++round)
  {
    if (run_round(round, n_sweeps, progress))
      return unbalanced_report(step, unknowns, progress.iterations, options_.tolerance,
                               std::move(progress.trace));
    n_sweeps = std::clamp(2 * n_sweeps, first_sweeps, most_sweeps);
  }
  return make_report(step, unknowns, progress.iterations, options_.tolerance, std::move(progress.trace));
}

std::unique_ptr<ContactSolver> make_newton(const ContactSystem &system, const ContactSolverOptions &options)
{
  return system.compliance().dense() != nullptr ? make<SemismoothNewton>(system, options)
                                                : make_continuation(system, options);
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
