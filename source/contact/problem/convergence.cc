// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/problem/convergence.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace orthocone
{
namespace
{
using Points = std::vector<TracePoint>;

/// The point with half as many iterations as the last one: what follows it shows the trend.
Points::const_iterator middle_of(const Points &trace)
{
  return std::find_if(trace.begin(), trace.end(),
                      [&](const TracePoint &point)
                      { return point.iterations >= trace.back().iterations / 2; });
}

double least_residual(const Points::const_iterator begin, const Points::const_iterator end)
{
  return std::min_element(begin, end,
                          [](const TracePoint &a, const TracePoint &b) { return a.residual < b.residual; })
      ->residual;
}

/// Logarithm by which the least residual fell in the second half.
double fall(const Points &trace)
{
  const auto middle = middle_of(trace);
  return std::log(least_residual(trace.begin(), std::next(middle)) / least_residual(middle, trace.end()));
}

/// Whether nearly every residual of the second half is below the one before: an iteration that creeps does
/// not cycle.
bool creeps(const Points &trace)
{
  constexpr double rounding = 1e-12;
  constexpr double nearly_all = 0.9;
  std::ptrdiff_t n_falls = 0;
  for (auto point = std::next(middle_of(trace)); point < trace.end(); ++point)
    n_falls += point->residual < (1 - rounding) * std::prev(point)->residual ? 1 : 0;
  return static_cast<double>(n_falls) >= nearly_all * static_cast<double>(trace.end() - middle_of(trace) - 1);
}
} // namespace

void Trace::add(const unsigned int iterations, const double residual, const double force)
{
  const std::chrono::duration<double> seconds = Clock::now() - begin_;
  points_.push_back({iterations, residual, force, seconds.count()});
}

const char *to_word(const Verdict verdict)
{
  switch (verdict)
  {
  case Verdict::converged:
    return "converged";
  case Verdict::slow:
    return "slow";
  case Verdict::rounding:
    return "rounding";
  case Verdict::cycling:
    return "cycling";
  case Verdict::diverged:
    return "diverged";
  case Verdict::unbalanced:
    return "unbalanced";
  case Verdict::several:
    return "several";
  }
  return "";
}

Verdict judge(const Points &trace, const double tolerance, const double rounding)
{
  constexpr std::size_t few = 4;       // points that show no trend
  constexpr double growth = 10;        // of forces that have no bound, in half of the iterations
  constexpr double least_fall = 0.105; // a tenth of the residual in half of the iterations
  if (trace.empty())
    return Verdict::slow;
  const TracePoint &last = trace.back();
  if (last.residual <= tolerance)
    return Verdict::converged;
  if (!std::isfinite(last.residual))
    return Verdict::diverged;
  if (trace.size() >= few && last.force > growth * middle_of(trace)->force)
    return Verdict::diverged;
  if (least_residual(trace.begin(), trace.end()) <= rounding)
    return Verdict::rounding;
  return trace.size() < few || fall(trace) > least_fall || creeps(trace) ? Verdict::slow : Verdict::cycling;
}

double iterations_to_go(const Points &trace, const double tolerance)
{
  if (trace.empty() || !(fall(trace) > 0))
    return 0;
  const double rate = fall(trace) / (trace.back().iterations - middle_of(trace)->iterations);
  return std::ceil(std::log(least_residual(trace.begin(), trace.end()) / tolerance) / rate);
}
} // namespace orthocone
