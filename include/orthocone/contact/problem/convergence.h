// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <chrono>
#include <vector>

namespace orthocone
{
/// Residual and force at one moment of a load step.
struct TracePoint
{
  unsigned int iterations; ///< done so far
  double residual;         ///< ContactStep::residual()
  double force;            ///< ContactStep::force_scale(), N: residuals are relative to it
  double seconds;          ///< wall time since the solver began
};

/// The residuals that a solver has evaluated in a load step, in their order.
class Trace
{
public:
  /// Adds a point at the present time; `force` is in N.
  void add(unsigned int iterations, double residual, double force);
  const std::vector<TracePoint> &points() const { return points_; }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
  std::vector<TracePoint> points_;
};

/// How an iteration ended.
enum class Verdict
{
  converged,  ///< within the tolerance
  slow,       ///< the residual still fell when the iterations were used up
  rounding,   ///< the residual reached what rounding leaves, but not the tolerance
  cycling,    ///< the residual no longer fell, and the forces stayed in bounds
  diverged,   ///< the forces grew without bound, or are no longer numbers
  unbalanced, ///< the held face runs away: no contact forces balance what drives it
  several,    ///< there are several solutions near here, and the way to the wanted one turns back too often
};

/// The word of a verdict.
const char *to_word(Verdict verdict);

/// Judges an iteration by its trace (docs/theory.md, section 3). `tolerance` bounds the relative residual;
/// `rounding` is the residual below which rounding decides. An empty trace is slow.
Verdict judge(const std::vector<TracePoint> &trace, double tolerance, double rounding);

/// How many more iterations would bring the residual within the tolerance if it kept falling as in the second
/// half of the trace; 0 where it does not fall.
double iterations_to_go(const std::vector<TracePoint> &trace, double tolerance);
} // namespace orthocone
