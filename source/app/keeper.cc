// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "keeper.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>

namespace orthocone
{
namespace
{
using Message = nlohmann::json;

constexpr std::size_t largest_request = 100000; // bytes; sockets of Linux take twice as many

double own_cpu_seconds()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval &time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void wait_for(const pid_t process)
{
  while (::waitpid(process, nullptr, 0) < 0 && errno == EINTR)
  {
  }
}

/// A process that the batch inherits: the one between ends at once, and the kernel gives orphans to the next
/// ancestor that asks for them. Returns -1 where there is no such process.
pid_t fork_orphan(const std::function<void()> &work)
{
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    return -1;
  const pid_t between = ::fork();
  if (between == 0)
  {
    const pid_t child = ::fork();
    if (child == 0)
    {
      ::close(ends[0]);
      ::close(ends[1]);
      work();
    }
    const bool is_told = ::write(ends[1], &child, sizeof child) == sizeof child;
    ::_exit(is_told ? 0 : 1);
  }
  ::close(ends[1]);
  pid_t child = -1;
  if (between > 0 && ::read(ends[0], &child, sizeof child) != sizeof child)
    child = -1;
  ::close(ends[0]);
  if (between > 0)
    wait_for(between);
  return child;
}

/// The keeper: prepares and forks for each request, until the batch closes its end.
[[noreturn]] void keep(const int socket, const std::function<void(const Keeper::Words &)> &prepare,
                       const Runner &run, const std::deque<ChildOutput> &outputs)
{
  std::string request(largest_request, '\0');
  for (ssize_t n = 0; (n = ::recv(socket, request.data(), request.size(), 0)) > 0;)
  {
    const Message json = Message::parse(request.begin(), request.begin() + n);
    const auto words = json.at("words").get<Keeper::Words>();
    const ChildOutput &files = outputs.at(json.at("output").get<std::size_t>());
    const double before = own_cpu_seconds();
    prepare(words);
    const pid_t child = fork_orphan(
        [&]
        {
          ::close(socket);
          run_as_child(words, files, run);
        });
    const Keeper::Started started{child, own_cpu_seconds() - before};
    if (::send(socket, &started, sizeof started, MSG_NOSIGNAL) != sizeof started)
      break;
  }
  ::_exit(0);
}

/// Nothing that a library says in the keeper is an answer of a run.
void be_silent()
{
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::dup2(nowhere, stream);
}
} // namespace

Keeper::Keeper(const std::function<void(const Words &)> &prepare, const Runner &run,
               const std::deque<ChildOutput> &outputs)
{
  std::array<int, 2> ends{};
  if (::prctl(PR_SET_CHILD_SUBREAPER, 1) != 0 ||
      ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
    return;
  keeper_ = ::fork();
  if (keeper_ == 0)
    try
    {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::close(ends[0]);
      be_silent();
      release_signals();
      keep(ends[1], prepare, run, outputs);
    }
    catch (const std::exception &)
    {
      ::_exit(1);
    }
  ::close(ends[1]);
  socket_ = ends[0];
}

Keeper::~Keeper()
{
  ::close(socket_);
  if (keeper_ > 0)
    wait_for(keeper_);
}

std::optional<Keeper::Started> Keeper::start(const Words &words, const std::size_t output)
{
  const std::string request = Message{{"words", words}, {"output", output}}.dump();
  Started started{-1, 0};
  if (keeper_ < 0 || request.size() > largest_request ||
      ::send(socket_, request.data(), request.size(), MSG_NOSIGNAL) < 0)
    return std::nullopt;
  ssize_t n = 0;
  while ((n = ::recv(socket_, &started, sizeof started, 0)) < 0 && errno == EINTR)
  {
  }
  return n == sizeof started && started.child > 0 ? std::optional(started) : std::nullopt;
}
} // namespace orthocone
