// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "batch_child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <iostream>

namespace orthocone
{
namespace
{
volatile std::sig_atomic_t is_interrupted = 0;
sigset_t signals_before;

void on_interrupt(int)
{
  is_interrupted = 1;
}

void on_end_of_child(int) {}

/// Empties a file. Its processes have one place in it together.
void empty(const int file)
{
  if (::ftruncate(file, 0) == 0)
    ::lseek(file, 0, SEEK_SET);
}

std::string text_of(const int file)
{
  constexpr std::size_t most = 1000000; // bytes
  std::string text;
  std::array<char, 4096> buffer{};
  ssize_t n = 0;
  while (text.size() < most &&
         (n = ::pread(file, buffer.data(), buffer.size(), static_cast<off_t>(text.size()))) > 0)
    text.append(buffer.data(), static_cast<std::size_t>(n));
  return text;
}
} // namespace

ChildOutput::ChildOutput()
    : output_(::memfd_create("orthocone", MFD_CLOEXEC)),
      errors_(::memfd_create("orthocone", MFD_CLOEXEC))
{
}

ChildOutput::~ChildOutput()
{
  ::close(output_);
  ::close(errors_);
}

void ChildOutput::clear() const
{
  empty(output_);
  empty(errors_);
}

std::string ChildOutput::output() const
{
  return text_of(output_);
}

std::string ChildOutput::errors() const
{
  return text_of(errors_);
}

void ChildOutput::take() const
{
  ::dup2(output_, STDOUT_FILENO);
  ::dup2(errors_, STDERR_FILENO);
}

void hold_signals()
{
  sigset_t held;
  sigemptyset(&held);
  sigaddset(&held, SIGINT);
  sigaddset(&held, SIGCHLD);
  sigprocmask(SIG_BLOCK, &held, &signals_before);
  struct sigaction action
  {
  };
  action.sa_handler = on_interrupt;
  sigaction(SIGINT, &action, nullptr);
  action.sa_handler = on_end_of_child; // by itself the signal would not end a wait
  sigaction(SIGCHLD, &action, nullptr);
}

bool wait_for_input_or_signal(const bool for_input)
{
  pollfd input{STDIN_FILENO, POLLIN, 0};
  sigset_t held = signals_before;
  sigdelset(&held, SIGINT);
  sigdelset(&held, SIGCHLD);
  return ::ppoll(&input, for_input ? 1 : 0, nullptr, &held) > 0;
}

bool is_batch_interrupted()
{
  sigset_t waiting;
  return is_interrupted != 0 || (sigpending(&waiting) == 0 && sigismember(&waiting, SIGINT) == 1);
}

void release_signals()
{
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGCHLD, SIG_DFL);
  sigprocmask(SIG_SETMASK, &signals_before, nullptr);
}

void run_as_child(const std::vector<std::string> &words, const ChildOutput &files, const Runner &run)
{
  ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
  files.take();
  release_signals();
  const int code = run(words);
  std::cout.flush();
  ::_exit(code);
}
} // namespace orthocone
