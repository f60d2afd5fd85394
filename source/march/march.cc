// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/march.h>

#include <orthocone/base/stopwatch.h>

#include <utility>

namespace orthocone
{
MarchEnd march(const LoadSteps &steps, StepSolver &solver, ContactState &state, MarchObserver &observer)
{
  while (state.step < steps.size())
  {
    const LoadStep step = steps[state.step];
    if (!observer.goes_on(step))
      return MarchEnd::stopped;
    ContactState next = state;
    double seconds = 0;
    const SolverReport report = timed(seconds, [&] { return solver.solve(next, step); });
    if (!report.converged)
    {
      observer.failed(step, report, seconds);
      return MarchEnd::unsolved;
    }
    if (!observer.accepts({step, state, next, report, seconds}))
    {
      solver.reject();
      return MarchEnd::refused;
    }
    solver.accept(state, next, step);
    state = std::move(next);
    observer.accepted(state);
  }
  return MarchEnd::done;
}
} // namespace orthocone
