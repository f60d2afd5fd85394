// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "../rescue/nonlinear_elimination.h"
#include "../solvers.h"
#include "newton_steps.h"

#include <utility>

namespace orthocone
{
/// A step on the way to its solution.
struct NewtonProgress
{
  const ContactStep &step;
  Eigen::VectorXd &unknowns; ///< the best so far
  double residual;           ///< of them
  unsigned int iterations = 0;
  Trace trace{};

  void note(const double residual_, const Eigen::VectorXd &unknowns_)
  {
    trace.add(iterations, residual_, step.force_scale(unknowns_));
  }

  /// Takes unknowns that are better than the best so far.
  void offer(Eigen::VectorXd candidate)
  {
    const double its_residual = step.residual(candidate);
    if (!(its_residual < residual))
      return;
    residual = its_residual;
    unknowns = std::move(candidate);
    note(residual, unknowns);
  }
};

/// Newton's method with a dense compliance in three variants, which take turns (rescue/ladder.h). They differ
/// in how short a step may be, and in when they give up. Each starts from the unknowns of a
/// progress, and leaves better ones there if it finds any.
class NewtonPhases
{
public:
  /// `conditions` and `elimination`, which may be null, must outlive the phases.
  NewtonPhases(const ContactSolverOptions &options, const ConditionSolver &conditions,
               const NonlinearElimination *elimination);

  /// Up to the iterate where the error is least. The line search takes the shortest step where none reduces
  /// the error: that passes corners where pieces of the map meet. Where a few nodes keep the steps short,
  /// these are eliminated.
  void past_corners(NewtonProgress &progress) const;

  /// As long as each step pays.
  void while_steps_pay(NewtonProgress &progress) const;

  /// Every step in full, whatever the residual does on the way: where pieces of the
  /// map meet, line searches may stop at a corner that full steps pass.
  void in_full(NewtonProgress &progress) const;

private:
  bool eliminate(NewtonProgress &progress, Iterate &last, bool may_be_worse) const;
  bool may_iterate(const NewtonProgress &progress) const
  {
    return progress.iterations < options_.maximum_iterations;
  }

  ContactSolverOptions options_;
  const ConditionSolver &conditions_;
  const NonlinearElimination *elimination_;
  NewtonSteps steps_;
};
} // namespace orthocone
