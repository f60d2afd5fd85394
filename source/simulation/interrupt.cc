// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/interrupt.h>

#include <unistd.h>

#include <csignal>

namespace orthocone
{
namespace
{
volatile std::sig_atomic_t was_interrupted = 0;

void on_signal(int)
{
  was_interrupted = 1;
  constexpr char text[] = "\northocone: stops after this step; the same signal again stops at once\n";
  // Nothing can be done about a failure here.
  [[maybe_unused]] const auto n = ::write(STDERR_FILENO, text, sizeof(text) - 1);
}
} // namespace

void catch_signals()
{
  struct sigaction action
  {
  };
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_is_requested()
{
  return was_interrupted != 0;
}
} // namespace orthocone
