// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What this process may use of its machine, and what others use of it. Nothing but require_address_space()
// throws.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace orthocone
{
/// The least limit that `limit_in` reads in the directories of this process' control group and of the groups
/// above it, for `controller` ("memory", "cpu"), in the unit of `limit_in`; infinite where there is no limit.
/// Containers and batch systems set such limits. `limit_in` takes the directory, and whether it is one of
/// version 2.
double least_in_control_groups(const std::string &controller,
                               const std::function<double(const std::string &, bool)> &limit_in);

/// The memory that this process may use in all.
struct MemoryLimit
{
  double gigabytes;
  std::string source; ///< "this machine has", "'ulimit -v' leaves", "the control group allows"
};

/// The least of three: what the machine has, what control groups allow, and what is left of the address space
/// (RLIMIT_AS).
MemoryLimit memory_limit();

/// Memory that this process and others beside it could take now without others losing theirs: what the
/// machine and the control groups have left, GB. Infinite where nothing is known.
double free_gigabytes();

/// What the limit of the address space (RLIMIT_AS) leaves, bytes; infinite where there is none.
double free_address_space();

/// Throws InputError if less of the address space is left than any run needs. OpenBLAS asks for memory in
/// threads of its own, and would wait for it for ever.
void require_address_space();

/// Cores that this process may use.
struct UsableCores
{
  unsigned int allowed = 1; ///< by its affinity
  unsigned int granted = 1; ///< of these, as many at a time as its control group grants
};
UsableCores usable_cores();

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
