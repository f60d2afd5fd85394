// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <chrono>

namespace orthocone
{
/// Measures the seconds since its construction.
class Stopwatch
{
public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// Returns what `work` returns and adds its wall time to `seconds`.
template<typename Work>
auto timed(double &seconds, const Work &work)
{
  struct Adder
  {
    ~Adder() { total += watch.seconds(); }
    double &total;
    Stopwatch watch;
  } adder{seconds, {}};
  return work();
}
} // namespace orthocone
