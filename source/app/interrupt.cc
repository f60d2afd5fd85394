// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "interrupt.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/ranks.h>

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>

namespace orthocone
{
namespace
{
volatile std::sig_atomic_t was_interrupted = 0;
volatile std::sig_atomic_t lets_steps_finish = 0;
volatile std::sig_atomic_t speaks = 1;

/// Prints a text if this process reports; nothing can be done about a failure here.
template<std::size_t size>
void print_signal_text(const char (&text)[size])
{
  if (speaks == 0)
    return;
  [[maybe_unused]] const auto n = ::write(STDERR_FILENO, text, size - 1);
}

void on_signal(int)
{
  const int error = errno;
  if (lets_steps_finish == 0)
  {
    print_signal_text("\northocone: interrupted during the set-up; the same command with --resume goes on\n");
    ::_exit(static_cast<int>(ExitCode::interrupted));
  }
  was_interrupted = 1;
  print_signal_text("\northocone: stops after this iteration; the same signal again stops at once\n");
  errno = error;
}
} // namespace

void catch_signals()
{
  speaks = n_ranks() == 1 ? 1 : 0; // mpirun sends SIGTERM where a process has failed, too
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  struct sigaction action
  {
  };
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  for (const int number : {SIGINT, SIGTERM, SIGHUP})
  {
    struct sigaction before
    {
    };
    sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) // nohup ignores it
      sigaction(number, &action, nullptr);
  }
}

void let_steps_finish()
{
  lets_steps_finish = 1;
}

bool stop_is_requested()
{
  return was_interrupted != 0;
}
} // namespace orthocone
