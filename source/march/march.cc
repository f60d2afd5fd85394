// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/march.h>

#include <orthocone/base/stop_point.h>
#include <orthocone/base/stopwatch.h>

#include <optional>
#include <utility>

namespace orthocone
{
/// Solves a step; nothing where the observer gives it up.
static std::optional<SolverReport> solve_unless_stopped(StepSolver &solver, ContactState &state,
                                                        const LoadStep &step, MarchObserver &observer)
{
  const Stoppable stoppable([&] { return observer.is_to_stop(); });
  try
  {
    return solver.solve(state, step);
  }
  catch (const Stopped &)
  {
    solver.reject();
    return std::nullopt;
  }
}

MarchEnd march(const LoadSteps &steps, StepSolver &solver, ContactState &state, MarchObserver &observer)
{
  while (state.step < steps.size())
  {
    const LoadStep step = steps[state.step];
    if (!observer.goes_on(step))
      return MarchEnd::stopped;
    ContactState next = state;
    double seconds = 0;
    const auto report = timed(seconds, [&] { return solve_unless_stopped(solver, next, step, observer); });
    if (!report)
    {
      observer.goes_on(step); // says why it did not
      return MarchEnd::stopped;
    }
    if (!report->converged)
    {
      observer.failed(step, *report, seconds);
      return MarchEnd::unsolved;
    }
    if (!observer.accepts({step, state, next, *report, seconds}))
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
