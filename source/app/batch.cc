// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "batch.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/stopwatch.h>

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <optional>

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

/// The present run gets the signal, too, and finishes its step; its answer is the last one.
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
  return {{"exit", code}, {"cpu_seconds", 0}, {"seconds", 0}, {"message", message}, {"output", ""}};
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

/// A file in memory, without a name, that a child writes and its parent reads.
class Scratch
{
public:
  Scratch()
      : file_(::memfd_create("orthocone", MFD_CLOEXEC))
  {
  }
  ~Scratch() { ::close(file_); }
  Scratch(const Scratch &) = delete;
  Scratch &operator=(const Scratch &) = delete;

  int file() const { return file_; }

  /// The text that was written, cut to a length that somebody would read.
  std::string text() const
  {
    constexpr std::size_t most = 1000000; // bytes
    std::string text;
    std::array<char, 4096> buffer{};
    ::lseek(file_, 0, SEEK_SET);
    for (ssize_t n = 0; text.size() < most && (n = ::read(file_, buffer.data(), buffer.size())) > 0;)
      text.append(buffer.data(), static_cast<std::size_t>(n));
    return text;
  }

private:
  int file_;
};

[[noreturn]] void run_as_child(const std::vector<std::string> &words, const int output, const int errors,
                               const Runner &run)
{
  ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  std::signal(SIGINT, SIG_DFL);
  const int code = run(words);
  std::cout.flush();
  ::_exit(code);
}

Json run_line(const std::vector<std::string> &words, const Runner &run)
{
  constexpr int signal_base = 128; // as shells do
  const Stopwatch watch;
  const Scratch output, errors;
  const pid_t child = output.file() < 0 || errors.file() < 0 ? -1 : ::fork();
  if (child == 0)
    run_as_child(words, output.file(), errors.file(), run);
  if (child < 0)
    return answer(static_cast<int>(ExitCode::unsolved_step), std::strerror(errno));
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0 && errno == EINTR)
  {
  }
  Json json = answer(WIFEXITED(status) ? WEXITSTATUS(status) : signal_base + WTERMSIG(status), errors.text());
  json["cpu_seconds"] = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  json["seconds"] = watch.seconds();
  json["output"] = output.text();
  return json;
}
} // namespace

bool run_batch(std::istream &lines, std::ostream &answers, const Runner &run)
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
  return is_interrupted == 0;
}
} // namespace orthocone
