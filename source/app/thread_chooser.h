// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "command_line.h"

#include <orthocone/base/machine.h>
#include <orthocone/base/threads.h>

#include <optional>

namespace orthocone
{
/// Decides once how many threads a run computes with. From its construction on it measures the load by
/// others.
class ThreadChooser
{
public:
  explicit ThreadChooser(const CommandLine &line)
      : on_command_line_(line.threads)
  {
  }

  /// To be called before choose() if the run must go on with the same bytes as an earlier one.
  void go_on_with(unsigned int n_threads) { of_run_before_ = n_threads; }

  /// The first call decides and sets the threads of the libraries. `unknowns`: their number in the model.
  const ThreadChoice &choose(double unknowns);

  /// The choice. Throws std::bad_optional_access before choose().
  const ThreadChoice &chosen() const { return chosen_.value(); }

private:
  ThreadChoice decide(double unknowns) const;

  const MachineLoad load_;
  const unsigned int on_command_line_;
  unsigned int of_run_before_ = 0;
  std::optional<ThreadChoice> chosen_{};
};
} // namespace orthocone
