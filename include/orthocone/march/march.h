// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/step_solver.h>

#include <vector>

namespace orthocone
{
/// A step that is solved, and not accepted yet.
struct MarchedStep
{
  const LoadStep &step;
  const ContactState &before;
  const ContactState &after;
  const SolverReport &report;
  double seconds; ///< of the solver
};

/// Watches a march: for results, tables, checkpoints, a search. A new observer is a class derived from this
/// one.
class MarchObserver
{
public:
  virtual ~MarchObserver() = default;

  /// Whether the march goes on with `next`.
  virtual bool goes_on(const LoadStep & /*next*/) { return true; }

  /// Whether the step that is being solved is to be given up between two iterations. If so, goes_on() is
  /// asked again and must say no, and the march ends in the state before the step. All processes must say the
  /// same.
  virtual bool is_to_stop() { return false; }

  /// Whether a solved step is right. If it is not, the march ends with the state before it.
  virtual bool accepts(const MarchedStep & /*solved*/) { return true; }

  /// Called after a step is accepted. May move the state on, as a jump over cycles does.
  virtual void accepted(ContactState & /*state*/) {}

  /// Called when no halving solves a step, which ends the march in the state before it.
  virtual void failed(const LoadStep & /*step*/, const SolverReport & /*report*/, double /*seconds*/) {}
};

/// How a march ended.
enum class MarchEnd
{
  done,     ///< all steps are accepted
  stopped,  ///< the observer did not go on, or stopped a step
  unsolved, ///< a step is not solved
  refused,  ///< a step is solved, but not accepted
};

/// Solves the steps that lie behind `state`, one after another: the loop of every run.
MarchEnd march(const LoadSteps &steps, StepSolver &solver, ContactState &state, MarchObserver &observer);
} // namespace orthocone
