// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The method `newton`: what it tries, in which order, and when. docs/theory.md, section 3, "The ladder".
#include "ladder.h"

#include "../face/load_limit.h"
#include "../face/unheld_face.h"
#include "../newton/inexact_newton.h"
#include "../newton/newton_phases.h"
#include "../sweeps/gauss_seidel.h"
#include "continuation.h"
#include "friction_path.h"
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
/// What is tried in these rounds while a step is open, where the condition holds.
template<typename Attempt>
struct Rung
{
  unsigned int first_round, last_round;
  const char *name;
  bool (Attempt::*condition)() const;
  void (Attempt::*method)();
};

constexpr unsigned int ever = std::numeric_limits<unsigned int>::max();

/// One round of a ladder, up to the rung that solves the step.
template<typename Attempt, std::size_t n>
void climb(const Rung<Attempt> (&ladder)[n], Attempt &attempt, const unsigned int round)
{
  for (const Rung<Attempt> &rung : ladder)
    if (rung.first_round <= round && round <= rung.last_round && attempt.is_open() &&
        (attempt.*rung.condition)())
      (attempt.*rung.method)();
}

/// Semismooth Newton with a dense W, and what it has beside its own steps.
struct DenseNewton : ContactSolver
{
  /// Small problems that the method makes of its own have neither elimination nor proximal steps.
  DenseNewton(const ContactSystem &system, const ContactSolverOptions &options_, const bool is_small = true)
      : options(options_),
        sweeps(system, options_),
        conditions(condition_solver(system, "newton")),
        elimination(is_small ? nullptr : std::make_unique<NonlinearElimination>(options, make<DenseNewton>)),
        proximal_steps(is_small ? nullptr
                                : std::make_unique<ProximalSteps>(system, options, make<DenseNewton>)),
        phases(options, *conditions, elimination.get())
  {
  }

  SolverReport solve(const ContactStep &step, VectorXd &unknowns) const override;
  std::optional<SolverReport> rescue(const ContactStep &step, VectorXd &unknowns) const override;

  ContactSolverOptions options;
  GaussSeidel sweeps;
  std::unique_ptr<const ConditionSolver> conditions;
  std::unique_ptr<const NonlinearElimination> elimination;
  std::unique_ptr<const ProximalSteps> proximal_steps; ///< for singular W
  NewtonPhases phases;
};

/// A step on the ladder of a dense W.
class DenseAttempt
{
public:
  DenseAttempt(const DenseNewton &newton, const ContactStep &step, VectorXd &unknowns)
      : newton_(newton),
        step_(step),
        start_(unknowns),
        start_residual_(step.residual(unknowns)),
        progress_{step, unknowns, start_residual_}
  {
  }

  /// Whether the step is neither solved nor lost.
  bool is_open() const
  {
    return progress_.residual > newton_.options.tolerance && std::isfinite(progress_.residual);
  }

  SolverReport solve();

  bool always() const { return true; }
  bool face_is_unheld() const { return is_unheld_without_forces(step_, progress_.unknowns); }
  bool few_nodes_show_that_w_is_singular() const
  {
    return newton_.proximal_steps && newton_.proximal_steps->are_needed_by_few_nodes();
  }
  bool w_is_singular() const
  {
    return newton_.proximal_steps && !few_nodes_show_that_w_is_singular() &&
           newton_.proximal_steps->are_needed();
  }

  void press_face();
  void sweep_then_take_proximal_steps();
  void return_to_start();
  void sweep();
  void steps_past_corners() { newton_.phases.past_corners(progress_); }
  void steps_that_pay() { newton_.phases.while_steps_pay(progress_); }
  void full_steps() { newton_.phases.in_full(progress_); }

private:
  bool may_iterate(const unsigned int n = 1) const
  {
    return progress_.iterations + n <= newton_.options.maximum_iterations;
  }
  void sweep_while_promising();

  const DenseNewton &newton_;
  const ContactStep &step_;
  const VectorXd start_;
  const double start_residual_;
  NewtonProgress progress_;
  unsigned int round_ = 0;
};

using OnDense = DenseAttempt;

/// With a dense W. Rounds follow each other until the step is solved, the iterations are used up, or the face
/// runs away. Newton's steps on the natural map open, because most steps of a program need no sweeps then
/// (docs/performance.md). Where both line searches stall, exact sweeps give the method their robustness.
constexpr Rung<OnDense> dense_ladder[] = {
    {0, 0, "forces that press an unheld face", &OnDense::face_is_unheld, &OnDense::press_face},
    {0, 0, "sweeps, then proximal steps", &OnDense::few_nodes_show_that_w_is_singular,
     &OnDense::sweep_then_take_proximal_steps},
    {0, 0, "steps past corners, with nonlinear elimination", &OnDense::always, &OnDense::steps_past_corners},
    {0, 0, "steps while they pay", &OnDense::always, &OnDense::steps_that_pay},
    {1, 1, "back to the start", &OnDense::always, &OnDense::return_to_start},
    {1, 1, "sweeps, then proximal steps", &OnDense::w_is_singular, &OnDense::sweep_then_take_proximal_steps},
    {1, ever, "sweeps", &OnDense::always, &OnDense::sweep},
    {1, ever, "steps while they pay", &OnDense::always, &OnDense::steps_that_pay},
    {1, ever, "steps past corners, with nonlinear elimination", &OnDense::always,
     &OnDense::steps_past_corners},
    {1, ever, "full steps", &OnDense::always, &OnDense::full_steps},
};

SolverReport DenseAttempt::solve()
{
  progress_.note(start_residual_, start_);
  BalanceWatch watch;
  Balance balance = Balance::judged;
  for (; is_open() && may_iterate() && balance != Balance::lost; ++round_)
  {
    climb(dense_ladder, *this, round_);
    // The proof costs less than the sweeps of the next round, which would run in vain.
    if (is_open() &&
        (watch.runs_away(step_, progress_.unknowns) || (round_ == 0 && is_beyond_every_force(step_))))
      balance = Balance::lost;
  }
  return make_report(step_, progress_.unknowns, progress_.iterations, newton_.options.tolerance,
                     std::move(progress_.trace), balance);
}

/// Forces that balance the load, and the motion of the face that brings the nodes back where they push them
/// off.
void DenseAttempt::press_face()
{
  VectorXd &unknowns = progress_.unknowns;
  unknowns = balancing_start(step_);
  const NodeVector moved = step_.displacement(unknowns);
  unknowns.tail(step_.face().n()) -= step_.face().columns().transpose() * moved;
  progress_.residual = step_.residual(unknowns);
}

/// Sweeps solve steps of few bodies or from good starts: with a hundred nodes all of them cost as much as
/// four of Newton's steps, and with a sparse W five times as many do. They end where twice as many would not
/// do at their pace.
void DenseAttempt::sweep_while_promising()
{
  constexpr unsigned int interval = 20;
  const unsigned int most_sweeps = step_.system().compliance().is_sparse() ? 2000 : 400;
  VectorXd swept = progress_.unknowns;
  bool is_promising = true;
  for (unsigned int n = interval; is_promising && is_open() && n <= most_sweeps && may_iterate(interval);
       n += interval)
  {
    const double last = progress_.residual;
    for (unsigned int i = 0; i < interval; ++i, ++progress_.iterations)
      newton_.sweeps.sweep(step_, swept, 1);
    progress_.offer(swept);
    const double pace = progress_.residual / last, looks = 2. * (most_sweeps - n) / interval;
    is_promising = progress_.residual * std::pow(pace, looks) <= newton_.options.tolerance;
  }
}

void DenseAttempt::sweep_then_take_proximal_steps()
{
  VectorXd improved = progress_.unknowns;
  sweep_while_promising();
  if (!is_open())
    return;
  const unsigned int iterations_left = newton_.options.maximum_iterations - progress_.iterations;
  progress_.iterations += newton_.proximal_steps->improve(step_, improved, iterations_left);
  progress_.offer(step_.admissible(std::move(improved)));
}

/// Sweeps from where Newton's steps stalled may lead to another solution than sweeps from the start, and the
/// next load step may have none behind it (docs/stability.md).
void DenseAttempt::return_to_start()
{
  progress_.unknowns = start_;
  progress_.residual = start_residual_;
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

void DenseAttempt::sweep()
{
  constexpr unsigned int first = 10, most_doublings = 4; // docs/theory.md, section 3
  const unsigned int n_sweeps = first << std::min(round_ - 1, most_doublings);
  for (unsigned int i = 0; i < n_sweeps && may_iterate(); ++i, ++progress_.iterations)
    newton_.sweeps.sweep(step_, progress_.unknowns, relaxation_of_round(round_));
}

SolverReport DenseNewton::solve(const ContactStep &step, VectorXd &unknowns) const
{
  return DenseAttempt(*this, step, unknowns).solve();
}

/// From the solution with hardly any friction, which always exists where the face is held and is found
/// easily.
std::optional<SolverReport> DenseNewton::rescue(const ContactStep &step, VectorXd &unknowns) const
{
  constexpr double first_share = 0.01, most_operations = 3e11; // of factorizations: docs/stability.md
  VectorXd start = VectorXd::Zero(step.n_unknowns());
  if (!solve(step.with_factors(FrictionPieces(step).factors(first_share)), start).converged)
    return std::nullopt;
  FrictionPath path(step, start, first_share);
  const bool is_at_end = path.follow(options.maximum_iterations, most_operations);
  if (!is_at_end && path.folds().n == 0)
    return std::nullopt;
  VectorXd found = step.admissible(path.unknowns());
  NewtonProgress progress{step, found, step.residual(found), path.n_factorizations()};
  if (is_at_end)
    phases.while_steps_pay(progress);
  SolverReport report = make_report(step, found, progress.iterations, options.tolerance, progress.trace);
  report.folds = path.folds();
  if (report.converged)
    unknowns = std::move(found);
  else
    report.verdict = Verdict::several;
  return report;
}

/// Newton's method on a body without a dense W.
struct WholeBodyNewton : ContactSolver
{
  WholeBodyNewton(const ContactSystem &system, const ContactSolverOptions &options,
                  const Allowances &allowances, const Continue from)
      : on_natural_map(make_inexact_newton(system, options, allowances)),
        on_elliptic_cone(
            make_inexact_newton(system, options, without_groups(allowances), linearize_on_elliptic_cone))
  {
    if (from == Continue::from_easier)
      continuation.emplace(options);
  }

  SolverReport solve(const ContactStep &step, VectorXd &unknowns) const override;

  std::unique_ptr<const ContactSolver> on_natural_map, on_elliptic_cone;
  std::optional<const Continuation> continuation{};
};

/// A step on the ladder of a body without a dense W.
class WholeBodyAttempt
{
public:
  WholeBodyAttempt(const WholeBodyNewton &newton, const ContactStep &step, VectorXd &unknowns)
      : newton_(newton),
        step_(step),
        start_(unknowns),
        unknowns_(unknowns)
  {
  }

  SolverReport solve();

  /// Whether another method may find what the last one did not.
  bool is_open() const
  {
    return report_.verdict == Verdict::cycling || report_.verdict == Verdict::slow ||
           report_.verdict == Verdict::diverged;
  }

  bool always() const { return true; }
  bool laws_are_ellipses() const
  {
    return std::all_of(step_.laws().begin(), step_.laws().end(),
                       [](const FrictionLaw &law) { return law.ellipse() != nullptr; });
  }
  bool laws_are_hard() const { return newton_.continuation && has_easier_laws(step_); }

  void natural_map() { solve_by(*newton_.on_natural_map); }
  void map_on_elliptic_cone() { solve_by(*newton_.on_elliptic_cone); }
  void follow_from_easier_law();

private:
  void solve_by(const ContactSolver &solver)
  {
    const unsigned int iterations = report_.iterations;
    unknowns_ = start_;
    report_ = solver.solve(step_, unknowns_);
    report_.iterations += iterations;
  }

  const WholeBodyNewton &newton_;
  const ContactStep &step_;
  const VectorXd start_;
  VectorXd &unknowns_;
  SolverReport report_{}; ///< of the last method, with the iterations of all
};

using OnBody = WholeBodyAttempt;

/// Without a dense W there are no sweeps. Each method begins at the start. The natural map stalls less often
/// than that on the elliptic cone, whose slopes differ, so that each gets away from where the other one
/// stalls.
constexpr Rung<OnBody> whole_body_ladder[] = {
    {0, 0, "natural map, with exact nodes", &OnBody::always, &OnBody::natural_map},
    {0, 0, "map on the elliptic cone", &OnBody::laws_are_ellipses, &OnBody::map_on_elliptic_cone},
    {0, 0, "continuation from easier laws", &OnBody::laws_are_hard, &OnBody::follow_from_easier_law},
};

SolverReport WholeBodyAttempt::solve()
{
  climb(whole_body_ladder, *this, 0);
  return std::move(report_);
}

/// Where the continuation fails, the failure that is reported is that of the given laws.
void WholeBodyAttempt::follow_from_easier_law()
{
  Continuation::Path path{start_};
  const unsigned int iterations = report_.iterations;
  if (auto followed = newton_.continuation->follow(step_, path))
  {
    report_ = *std::move(followed);
    unknowns_ = std::move(path.unknowns);
  }
  report_.iterations = iterations + path.iterations;
}

SolverReport WholeBodyNewton::solve(const ContactStep &step, VectorXd &unknowns) const
{
  return WholeBodyAttempt(*this, step, unknowns).solve();
}

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
  ContactMethod method{"newton", "semismooth Newton's method between sweeps of exact one-node solutions",
                       make_newton};
  method.needs_dense = false;
  method.rho = "1 / the largest diagonal entry of a node's compliance";
  return method;
}
} // namespace orthocone
