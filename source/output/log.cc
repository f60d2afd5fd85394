// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/output/log.h>

#include <orthocone/base/ranks.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace orthocone
{
namespace
{
/// The text, cut to the width of the terminal, or to 80 columns: a line that wraps cannot be overwritten in
/// place.
std::string fitted(const std::string &text)
{
  constexpr std::size_t usual = 80;
  winsize size{};
  const bool is_known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return text.substr(0, std::min<std::size_t>(usual, is_known ? size.ws_col : usual) - 1);
}

/// "[###-------] " with the share of `n_done` in `n_all`.
std::string bar(const unsigned int n_done, const unsigned int n_all)
{
  constexpr unsigned int width = 10;
  const unsigned int n_full = width * std::uint64_t(n_done) / n_all;
  return "[" + std::string(n_full, '#') + std::string(width - n_full, '-') + "] ";
}
} // namespace

Log::Log(RunFolder &folder, const bool is_quiet)
    : folder_(folder),
      is_quiet_(is_quiet),
      is_terminal_(isatty(STDOUT_FILENO) == 1 &&
                   !is_launched()) // under mpirun every file looks like a terminal
{
}

void Log::line(const std::string &text)
{
  finish_progress();
  folder_.append("log.txt", text + "\n");
  if (!is_quiet_)
    std::cout << text << std::endl;
}

void Log::note(const std::string &text)
{
  folder_.append("log.txt", text + "\n");
}

void Log::start_steps(const unsigned int n_done, const LoadSteps &steps)
{
  n_done_ = n_done;
  n_steps_ = steps.size();
  motion_text_ = MotionText(steps.different(), steps.loads());
  watch_ = Stopwatch();
}

void Log::progress(const LoadStep &step, const Totals &totals, const SolverReport &report)
{
  const double elapsed = watch_.seconds();
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "step " << step.number << " of " << n_steps_ << ", "
       << elapsed << " s, " << elapsed / (step.number - n_done_) * (n_steps_ - step.number)
       << " s left: " << motion_text_(step);
  const std::string in_short = text.str();
  text << ", open/stick/slip " << totals.n_open << "/" << totals.n_stick << "/" << totals.n_slip << ", "
       << report.iterations << " iterations, residual " << std::scientific << report.residual
       << ", penetration " << report.penetration << " mm";
  folder_.append("log.txt", text.str() + "\n");
  if (is_quiet_)
    return;
  if (is_terminal_)
    std::cout << "\r\033[K" << fitted(bar(step.number, n_steps_) + in_short) << std::flush;
  else
    std::cout << fitted(in_short) << std::endl;
  is_in_place_ = is_terminal_;
}

void Log::finish_progress()
{
  if (is_in_place_)
    std::cout << std::endl;
  is_in_place_ = false;
}
} // namespace orthocone
