// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The method `newton`: what it tries, in which order, and when. docs/theory.md, section 3, "The ladder".
#include "ladder.h"

#include "../face/unheld_face.h"
#include "../newton/inexact_newton.h"
#include "../newton/newton_phases.h"
#include "../sweeps/gauss_seidel.h"
#include "continuation.h"
#include "proximal_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// What is tried while a step is not solved: in these rounds, where the condition holds.
template<typename Attempt>
struct Rung
{
  unsigned int first_round, last_round;
  const char *name;
  bool (*condition)(const Attempt &);
  void (*method)(Attempt &);
};

constexpr unsigned int ever = std::numeric_limits<unsigned int>::max();

template<typename Attempt>
bool always(const Attempt &)
{
  return true;
}

/// One round of a ladder, up to the rung that solves the step.
template<typename Attempt, std::size_t n>
void climb(const Rung<Attempt> (&ladder)[n], Attempt &attempt, const unsigned int round)
{
  for (const Rung<Attempt> &rung : ladder)
    if (rung.first_round <= round && round <= rung.last_round && attempt.is_open() && rung.condition(attempt))
      rung.method(attempt);
}

/// What Newton's method has beside its steps where W is dense. Small problems that it makes of its own have
/// neither elimination nor proximal steps.
struct DenseTools
{
  DenseTools(const ContactSystem &system, const ContactSolverOptions &options_, bool is_of_small_problem);

  ContactSolverOptions options;
  GaussSeidel sweeps;
  std::unique_ptr<const ConditionSolver> conditions;
  std::unique_ptr<const NonlinearElimination> elimination{};
  std::unique_ptr<const ProximalSteps> proximal_steps{}; ///< for singular W
  NewtonPhases newton;
};

/// A step on the ladder of a dense W.
struct DenseAttempt
{
  /// Whether the step is neither solved nor lost.
  bool is_open() const
  {
    return progress.residual > tools.options.tolerance && std::isfinite(progress.residual);
  }

  bool may_iterate(const unsigned int n = 1) const
  {
    return progress.iterations + n <= tools.options.maximum_iterations;
  }

  const DenseTools &tools;
  NewtonProgress progress;
  const VectorXd start;
  const double start_residual;
  unsigned int round = 0;
};

bool face_is_unheld(const DenseAttempt &attempt)
{
  return is_unheld_without_forces(attempt.progress.step, attempt.progress.unknowns);
}

bool few_nodes_show_that_w_is_singular(const DenseAttempt &attempt)
{
  return attempt.tools.proximal_steps && attempt.tools.proximal_steps->are_needed_by_few_nodes();
}

bool w_is_singular(const DenseAttempt &attempt)
{
  return attempt.tools.proximal_steps && !few_nodes_show_that_w_is_singular(attempt) &&
         attempt.tools.proximal_steps->are_needed();
}

/// Forces that balance the load, and the motion of the face that brings the nodes back where they push them
/// off.
void press_face(DenseAttempt &attempt)
{
  NewtonProgress &progress = attempt.progress;
  const ContactStep &step = progress.step;
  progress.unknowns = balancing_start(step);
  const NodeVector moved = step.displacement(progress.unknowns);
  progress.unknowns.tail(step.face().n()) -= step.face().columns().transpose() * moved;
  progress.residual = step.residual(progress.unknowns);
}

/// Sweeps, which solve steps of few bodies or from good starts: with a hundred nodes all of them cost as much
/// as four of Newton's steps, and with a sparse W five times as many do. They end where twice as many would
/// not do at their pace.
void sweep_while_promising(DenseAttempt &attempt)
{
  constexpr unsigned int interval = 20;
  NewtonProgress &progress = attempt.progress;
  const ContactStep &step = progress.step;
  const unsigned int most_sweeps = step.system().compliance().is_sparse() ? 2000 : 400;
  VectorXd swept = progress.unknowns;
  bool is_promising = true;
  for (unsigned int n = interval;
       is_promising && attempt.is_open() && n <= most_sweeps && attempt.may_iterate(interval); n += interval)
  {
    const double last = progress.residual;
    for (unsigned int i = 0; i < interval; ++i, ++progress.iterations)
      attempt.tools.sweeps.sweep(step, swept, 1);
    progress.offer(swept);
    const double pace = progress.residual / last, looks = 2. * (most_sweeps - n) / interval;
    is_promising = progress.residual * std::pow(pace, looks) <= attempt.tools.options.tolerance;
  }
}

void sweep_then_take_proximal_steps(DenseAttempt &attempt)
{
  NewtonProgress &progress = attempt.progress;
  VectorXd improved = progress.unknowns;
  sweep_while_promising(attempt);
  if (!attempt.is_open())
    return;
  const unsigned int iterations_left = attempt.tools.options.maximum_iterations - progress.iterations;
  progress.iterations += attempt.tools.proximal_steps->improve(progress.step, improved, iterations_left);
  progress.offer(progress.step.admissible(std::move(improved)));
}

/// Sweeps from where Newton's steps stalled may lead to another solution than sweeps from the start, and the
/// next load step may have none behind it (docs/stability.md).
void return_to_start(DenseAttempt &attempt)
{
  attempt.progress.unknowns = attempt.start;
  attempt.progress.residual = attempt.start_residual;
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

/// Ten sweeps, and twice as many in each round (docs/theory.md, section 3).
void sweep(DenseAttempt &attempt)
{
  constexpr unsigned int first = 10, most = 160, most_doublings = 4;
  const unsigned int n_sweeps = std::min(first << std::min(attempt.round - 1, most_doublings), most);
  NewtonProgress &progress = attempt.progress;
  for (unsigned int i = 0; i < n_sweeps && attempt.may_iterate(); ++i, ++progress.iterations)
    attempt.tools.sweeps.sweep(progress.step, progress.unknowns, relaxation_of_round(attempt.round));
}

void solve_on_alart_curnier_map(DenseAttempt &attempt)
{
  attempt.tools.newton.on_alart_curnier_map(attempt.progress);
}

void solve_on_natural_map(DenseAttempt &attempt)
{
  attempt.tools.newton.on_natural_map(attempt.progress);
}

void solve_in_full_steps(DenseAttempt &attempt)
{
  attempt.tools.newton.in_full(attempt.progress);
}

/// With a dense W. Rounds follow each other until the step is solved, the iterations are used up, or the face
/// runs away. The map of Alart and Curnier opens, because the natural one stalls sooner
/// (docs/performance.md).
constexpr Rung<DenseAttempt> dense_ladder[] = {
    {0, 0, "forces that press an unheld face", face_is_unheld, press_face},
    {0, 0, "sweeps, then proximal steps", few_nodes_show_that_w_is_singular, sweep_then_take_proximal_steps},
    {0, 0, "Alart-Curnier map, with nonlinear elimination", always, solve_on_alart_curnier_map},
    {0, 0, "natural map", always, solve_on_natural_map},
    {1, 1, "back to the start", always, return_to_start},
    {1, 1, "sweeps, then proximal steps", w_is_singular, sweep_then_take_proximal_steps},
    {1, ever, "sweeps", always, sweep},
    {1, ever, "natural map", always, solve_on_natural_map},
    {1, ever, "Alart-Curnier map, with nonlinear elimination", always, solve_on_alart_curnier_map},
    {1, ever, "natural map in full steps", always, solve_in_full_steps},
};

/// Semismooth Newton on two maps, whose pieces meet elsewhere. Where both stall, it falls back on exact
/// sweeps, so that it inherits their robustness.
class DenseNewton : public ContactSolver
{
public:
  DenseNewton(const ContactSystem &system, const ContactSolverOptions &options,
              const bool is_of_small_problem = true)
      : tools_(system, options, is_of_small_problem)
  {
  }

  SolverReport solve(const ContactStep &step, VectorXd &unknowns) const override
  {
    const double residual = step.residual(unknowns);
    DenseAttempt attempt{tools_, {step, unknowns, residual}, unknowns, residual};
    attempt.progress.note(residual, unknowns);
    BalanceWatch watch;
    Balance balance = Balance::judged;
    for (; attempt.is_open() && attempt.may_iterate() && balance != Balance::lost; ++attempt.round)
    {
      climb(dense_ladder, attempt, attempt.round);
      if (attempt.is_open() && watch.runs_away(step, unknowns))
        balance = Balance::lost;
    }
    return make_report(step, unknowns, attempt.progress.iterations, tools_.options.tolerance,
                       std::move(attempt.progress.trace), balance);
  }

private:
  DenseTools tools_;
};

DenseTools::DenseTools(const ContactSystem &system, const ContactSolverOptions &options_,
                       const bool is_of_small_problem)
    : options(options_),
      sweeps(system, options_),
      conditions(condition_solver(system, "newton")),
      elimination(is_of_small_problem ? nullptr
                                      : std::make_unique<NonlinearElimination>(options_, make<DenseNewton>)),
      proximal_steps(is_of_small_problem
                         ? nullptr
                         : std::make_unique<ProximalSteps>(system, options_, make<DenseNewton>)),
      newton(options_, *conditions, elimination.get())
{
}

/// A step on the ladder of a body without a dense W.
struct WholeBodyAttempt
{
  /// Whether another method may find what the last one did not.
  bool is_open() const
  {
    return report.verdict == Verdict::cycling || report.verdict == Verdict::slow ||
           report.verdict == Verdict::diverged;
  }

  /// Each method begins at the start.
  void solve_by(const ContactSolver &solver)
  {
    const unsigned int iterations = report.iterations;
    unknowns = start;
    report = solver.solve(step, unknowns);
    report.iterations += iterations;
  }

  const ContactSolver &on_alart_curnier_map, &on_natural_map;
  const Continuation *continuation; ///< null: the slip rule is associated, or is not to be followed
  const ContactStep &step;
  VectorXd &unknowns;
  const VectorXd start;
  SolverReport report{};
};

bool slip_is_not_associated(const WholeBodyAttempt &attempt)
{
  return attempt.continuation != nullptr;
}

void solve_inexactly_on_alart_curnier_map(WholeBodyAttempt &attempt)
{
  attempt.solve_by(attempt.on_alart_curnier_map);
}

void solve_inexactly_on_natural_map(WholeBodyAttempt &attempt)
{
  attempt.solve_by(attempt.on_natural_map);
}

/// Where the continuation fails, the failure that is reported is that of the given slip rule.
void follow_from_associated_slip(WholeBodyAttempt &attempt)
{
  Continuation::Path path{attempt.start};
  const unsigned int iterations = attempt.report.iterations;
  if (auto followed = attempt.continuation->follow(attempt.step, path))
  {
    attempt.report = *std::move(followed);
    attempt.unknowns = std::move(path.unknowns);
  }
  attempt.report.iterations = iterations + path.iterations;
}

/// Without a dense W, and so without sweeps. The first map stalls less often.
constexpr Rung<WholeBodyAttempt> whole_body_ladder[] = {
    {0, 0, "Alart-Curnier map, with exact nodes", always, solve_inexactly_on_alart_curnier_map},
    {0, 0, "natural map, with exact nodes", always, solve_inexactly_on_natural_map},
    {0, 0, "continuation from associated slip", slip_is_not_associated, follow_from_associated_slip},
};

class WholeBodyNewton : public ContactSolver
{
public:
  WholeBodyNewton(const ContactSystem &system, const ContactSolverOptions &options,
                  const Allowances &allowances, const Continue from)
      : on_alart_curnier_map_(make_inexact_newton(system, options, allowances, linearize_alart_curnier)),
        on_natural_map_(make_inexact_newton(system, options, without_groups(allowances), linearize))
  {
    if (from == Continue::from_associated && !is_associated(system))
      continuation_.emplace(options);
  }

  SolverReport solve(const ContactStep &step, VectorXd &unknowns) const override
  {
    WholeBodyAttempt attempt{*on_alart_curnier_map_,
                             *on_natural_map_,
                             continuation_ ? &*continuation_ : nullptr,
                             step,
                             unknowns,
                             unknowns};
    climb(whole_body_ladder, attempt, 0);
    return std::move(attempt.report);
  }

private:
  std::unique_ptr<ContactSolver> on_alart_curnier_map_, on_natural_map_;
  std::optional<Continuation> continuation_{};
};

std::unique_ptr<ContactSolver> make_newton(const ContactSystem &system, const ContactSolverOptions &options)
{
  if (system.compliance().dense() == nullptr)
    return make_whole_body_newton(system, options);
  return std::make_unique<DenseNewton>(system, options, false);
}
} // namespace

std::unique_ptr<ContactSolver> make_whole_body_newton(const ContactSystem &system,
                                                      const ContactSolverOptions &options,
                                                      const Allowances &allowances, const Continue from)
{
  return std::make_unique<WholeBodyNewton>(system, options, allowances, from);
}

ContactMethod newton_method()
{
  ContactMethod method{"newton", "semismooth Newton between exact sweeps", make_newton};
  method.needs_dense = false;
  method.rho = "1 / the largest diagonal entry of a node's compliance";
  return method;
}
} // namespace orthocone
