// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "batch.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/stopwatch.h>

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <istream>
#include <optional>
#include <ostream>

namespace orthocone
{
namespace
{
using Json = nlohmann::ordered_json;

volatile std::sig_atomic_t is_interrupted = 0;

void on_interrupt(int)
{
  is_interrupted = 1;
}

/// The run that is going on gets the signal, too, and finishes its step; its answer is the last one.
void end_on_interrupt()
{
  struct sigaction action
  {
  };
  action.sa_handler = on_interrupt; // without SA_RESTART: waiting for a line ends
  sigaction(SIGINT, &action, nullptr);
}

double seconds(const timeval &time)
{
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Json answer(const int code, const std::string &message)
{
  return {{"exit", code}, {"cpu_seconds", 0}, {"seconds", 0}, {"message", message}};
}

std::optional<std::vector<std::string>> words_of(const std::string &line)
{
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_array())
    return std::nullopt;
  std::vector<std::string> words;
  for (const Json &word : json)
  {
    if (!word.is_string())
      return std::nullopt;
    words.push_back(word.get<std::string>());
  }
  return words;
}

/// Of the child: its error output goes to `errors`, nothing else anywhere.
[[noreturn]] void run_as_child(const std::vector<std::string> &words, const int errors, const Runner &run)
{
  const int nothing = ::open("/dev/null", O_RDWR);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  std::signal(SIGINT, SIG_DFL);
  ::_exit(run(words));
}

/// All that is written to a pipe, as far as anybody wants to read it.
std::string text_of(const int pipe)
{
  constexpr std::size_t most = 100000;
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t n = 0; (n = ::read(pipe, buffer.data(), buffer.size())) != 0;)
    if (n > 0 && text.size() < most)
      text.append(buffer.data(), static_cast<std::size_t>(n));
    else if (n < 0 && errno != EINTR)
      break;
  return text;
}

Json run_line(const std::vector<std::string> &words, const Runner &run)
{
  constexpr int signal_base = 128; // as shells do
  const Stopwatch watch;
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0)
    return answer(static_cast<int>(ExitCode::file_error), std::strerror(errno));
  const pid_t child = ::fork();
  if (child == 0)
  {
    ::close(pipe[0]);
    run_as_child(words, pipe[1], run);
  }
  ::close(pipe[1]);
  const std::string message = child > 0 ? text_of(pipe[0]) : std::strerror(errno);
  ::close(pipe[0]);
  if (child < 0)
    return answer(static_cast<int>(ExitCode::unsolved_step), message);
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0 && errno == EINTR)
  {
  }
  Json json = answer(WIFEXITED(status) ? WEXITSTATUS(status) : signal_base + WTERMSIG(status), message);
  json["cpu_seconds"] = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  json["seconds"] = watch.seconds();
  return json;
}
} // namespace

void run_batch(std::istream &lines, std::ostream &answers, const Runner &run)
{
  end_on_interrupt();
  for (std::string line; is_interrupted == 0 && std::getline(lines, line);)
  {
    const auto words = words_of(line);
    const Json json =
        words ? run_line(*words, run)
              : answer(static_cast<int>(ExitCode::wrong_input),
                       "orthocone: --batch: allowed is a JSON array of words in each line, such as "
                       "[\"FILE.prm\", \"--quiet\"]");
    answers << json.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
    if (!answers)
      throw FileError("standard output: cannot be written");
  }
}
} // namespace orthocone
