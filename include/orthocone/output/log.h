// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/stopwatch.h>
#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/output/motion_text.h>
#include <orthocone/output/run_folder.h>
#include <orthocone/results/totals.h>

namespace orthocone
{
/// log.txt and the output on the screen: one line for each step; on a terminal it is replaced in place,
/// behind a bar. Writing throws FileError.
class Log
{
public:
  /// `folder` must outlive the log. A quiet log writes to log.txt only.
  Log(RunFolder &folder, bool is_quiet);

  /// A line for the screen and for log.txt.
  void line(const std::string &text);

  /// A line for log.txt alone.
  void note(const std::string &text);

  /// Starts the clock of elapsed and remaining time. The first `n_done` of `steps` are solved already.
  void start_steps(unsigned int n_done, const LoadSteps &steps);

  /// Reports progress after `step`.
  void progress(const LoadStep &step, const Totals &totals, const SolverReport &report);

  /// Ends a line that is shown in place.
  void finish_progress();

private:
  RunFolder &folder_;
  bool is_quiet_;
  bool is_terminal_;
  bool is_in_place_ = false;
  Stopwatch watch_;
  unsigned int n_done_ = 0;
  unsigned int n_steps_ = 0;
  MotionText motion_text_;
};
} // namespace orthocone
