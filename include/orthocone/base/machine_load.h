// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <chrono>

namespace orthocone
{
/// Measures, from its construction on, how many cores of those that this process may use others keep busy: by
/// the times of idling that the kernel counts, because its number of running tasks has phantoms on virtual
/// machines.
class MachineLoad
{
public:
  MachineLoad();

  /// Cores that others were busy on since the construction, on average. Waits until that is long enough to be
  /// counted in hundredths of a second. 0 where nothing is known.
  double busy_cores() const;

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_;
  double busy_;   ///< of these cores since the machine was started, s; negative where nothing is known
  double by_own_; ///< of this process, s
};
} // namespace orthocone
