// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/contact_solver.h>
#include <orthocone/simulation/load_program.h>
#include <orthocone/simulation/run_folder.h>
#include <orthocone/simulation/stopwatch.h>
#include <orthocone/simulation/totals.h>

namespace orthocone
{
/// log.txt and what the screen shows: one line a step, in place on a terminal.
class Log
{
public:
  Log(const RunFolder &folder, bool is_quiet);

  /// A line for the screen and for log.txt.
  void line(const std::string &text);

  /// A line for log.txt alone.
  void note(const std::string &text) const;

  /// Elapsed and remaining time count from here, where `n_done` steps are solved already.
  void start_steps(unsigned int n_done);

  /// Progress after `step` of `n_steps`.
  void progress(const LoadStep &step, unsigned int n_steps, const Totals &totals, const SolverReport &report);

  /// Ends a line that is shown in place.
  void finish_progress();

private:
  const RunFolder &folder_;
  bool is_quiet_;
  bool is_terminal_;
  bool is_in_place_ = false;
  Stopwatch watch_;
  unsigned int n_done_ = 0;
};
} // namespace orthocone
