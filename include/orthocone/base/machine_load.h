// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <chrono>

namespace orthocone
{
/// Measures, from its construction on, how many of the cores that this process may use are kept busy by
/// others. It reads the idle times that the kernel counts, because the kernel's number of running tasks
/// includes phantoms on virtual machines.
class MachineLoad
{
public:
  MachineLoad();

  /// Number of cores that others have kept busy since the construction, on average. Waits until this is long
  /// enough to be counted in hundredths of a second. 0 where nothing is known.
  double busy_cores() const;

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
  double busy_;   ///< of these cores since the machine was started, s; negative where nothing is known
  double by_own_; ///< of this process, s
};
} // namespace orthocone
