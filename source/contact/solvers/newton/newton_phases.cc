// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "newton_phases.h"

#include "globalization.h"

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// Of the linear systems of Newton's steps: a tighter bound costs more products than it saves iterations.
constexpr double inexactness_of_newton = 0.01;

/// Where steps stall, which inexact ones do sooner; what single precision gives without trouble.
constexpr double inexactness_of_stalled_newton = 1e-4;

bool is_finite(const ContactChange &change)
{
  return change.force.allFinite() && change.face.allFinite();
}

/// The iterate with the least error so far.
struct Best
{
  VectorXd unknowns;
  double error; ///< of the map, N
  unsigned int number = 0;

  /// Returns whether an iterate is better than all before.
  bool offer(const Iterate &iterate, const unsigned int its_number)
  {
    const bool is_better = iterate.error < error;
    if (is_better)
      *this = {iterate.unknowns, iterate.error, its_number};
    return is_better;
  }
};
} // namespace

NewtonPhases::NewtonPhases(const ContactSolverOptions &options, const ConditionSolver &conditions,
                           const NonlinearElimination *const elimination)
    : options_(options),
      conditions_(conditions),
      elimination_(elimination),
      steps_(linearize, conditions, options.rho_factor)
{
}

/// Takes the state in which the hardest nodes are solved, and returns whether it has. For the other nodes
/// that state is worse as a rule. Newton's next steps mend this, while no step of the whole surface gets the
/// hardest nodes off their corners.
bool NewtonPhases::eliminate(NewtonProgress &progress, Iterate &last, const bool may_be_worse) const
{
  constexpr double bearable_growth = 1000;
  if (elimination_ == nullptr)
    return false;
  const NonlinearElimination::Result solved =
      elimination_->solve(progress.step, last.unknowns, last.displacement);
  progress.iterations += solved.iterations;
  if (!solved.unknowns)
    return false;
  Iterate next = steps_.at(progress.step, *solved.unknowns);
  if (!(next.error < (may_be_worse ? bearable_growth : 1) * last.error))
    return false;
  last = std::move(next);
  return true;
}

void NewtonPhases::past_corners(NewtonProgress &progress) const
{
  constexpr unsigned int most_iterations = 30, most_without_gain = 5;
  constexpr unsigned int pause = 3; // iterations that may mend what an elimination has made worse
  // The residual projects every node. The map's own error says without that where it may be small enough.
  constexpr unsigned int interval = 4;
  constexpr double likely = 10; // tolerances
  const ContactStep &step = progress.step;
  Iterate last = steps_.at(step, progress.unknowns);
  Best best{last.unknowns, last.error};
  unsigned int stalls_in_a_row = 0;
  for (unsigned int i = 0, i_eliminated = 0;
       i < most_iterations && i <= best.number + most_without_gain && may_iterate(progress); ++i)
  {
    // One stall is no sign: easy steps stall where nodes change their status, and get over it inexactly.
    const double accuracy = stalls_in_a_row < 2 ? inexactness_of_newton : inexactness_of_stalled_newton;
    const ContactChange change = steps_.change(step, last, accuracy);
    ++progress.iterations;
    if (!is_finite(change))
      break;
    const double error_before = last.error;
    last = steps_.search(step, last, change, {error_before, 1. / 16});
    const double small = likely * options_.tolerance * step.force_scale(last.unknowns);
    stalls_in_a_row = has_stalled(last.error, error_before) ? stalls_in_a_row + 1 : 0;
    if (stalls_in_a_row > 0 && last.error > small &&
        eliminate(progress, last, i_eliminated == 0 || i >= i_eliminated + pause))
      i_eliminated = i;
    const bool is_better = best.offer(last, i);
    if (!(last.error <= small) && i % interval != interval - 1)
      continue;
    const double residual = step.residual(last.unknowns, last.displacement);
    progress.note(residual, last.unknowns);
    if (is_better && residual <= options_.tolerance)
      break;
  }
  progress.offer(step.admissible(std::move(best.unknowns)));
}

void NewtonPhases::while_steps_pay(NewtonProgress &progress) const
{
  constexpr unsigned int most_iterations = 12;
  constexpr double paying_reduction = 0.9; // sweeps pay more for the same gain (docs/performance.md)
  const ContactStep &step = progress.step;
  Iterate best = steps_.at(step, progress.unknowns);
  // The error of the linearization would not do: its rho may be another one.
  const auto residual = [&] { return step.residual(best.unknowns, best.displacement); };
  progress.residual = residual();
  for (unsigned int i = 0; i < most_iterations && may_iterate(progress); ++i)
  {
    progress.note(residual(), best.unknowns);
    if (progress.trace.points().back().residual <= options_.tolerance)
      break;
    const double last_error = best.error;
    const ContactChange change = steps_.change(step, best, inexactness_of_newton);
    ++progress.iterations;
    if (!is_finite(change))
      break;
    Iterate next = steps_.search(step, best, change, {last_error});
    if (!(next.error < last_error))
      break;
    best = std::move(next);
    if (best.error > paying_reduction * last_error)
      break;
  }
  progress.offer(step.admissible(best.unknowns));
}

void NewtonPhases::in_full(NewtonProgress &progress) const
{
  constexpr unsigned int most_iterations = 15;
  const ContactStep &step = progress.step;
  VectorXd trial = progress.unknowns;
  for (unsigned int i = 0;
       i < most_iterations && may_iterate(progress) && progress.residual > options_.tolerance; ++i)
  {
    const auto linearization = linearize(step, trial, step.displacement(trial), options_.rho_factor);
    trial += newton_change(conditions_, linearization, inexactness_of_stalled_newton); // may leave the cone
    ++progress.iterations;
    if (!trial.allFinite())
      break;
    progress.offer(step.admissible(trial));
  }
}
} // namespace orthocone
