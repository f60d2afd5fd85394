// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "batch.h"

#include "keeper.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/stopwatch.h>

#include <nlohmann/json.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <deque>
#include <iostream>
#include <optional>

namespace orthocone
{
namespace
{
using Json = nlohmann::ordered_json;

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

/// The lines of standard input as far as they have come.
class InputLines
{
public:
  /// A whole line, or nothing where there is none yet. The last one may lack its end.
  std::optional<std::string> next()
  {
    const std::size_t end = read_.find('\n');
    if (end == std::string::npos && !(is_ended_ && !read_.empty()))
      return std::nullopt;
    const std::string line = read_.substr(0, end);
    read_.erase(0, end == std::string::npos ? end : end + 1);
    return line;
  }

  /// Whether no line will come any more.
  bool is_at_end() const { return is_ended_ && read_.empty(); }

  /// Reads what is there.
  void read()
  {
    std::array<char, 65536> piece{};
    const ssize_t n = ::read(STDIN_FILENO, piece.data(), piece.size());
    if (n > 0)
      read_.append(piece.data(), static_cast<std::size_t>(n));
    else if (n == 0 || (errno != EINTR && errno != EAGAIN))
      is_ended_ = true;
  }

private:
  std::string read_{};
  bool is_ended_ = false;
};

class Batch
{
public:
  Batch(const BatchProgram &program, const unsigned int jobs, std::ostream &answers)
      : program_(program),
        outputs_(std::max(1U, jobs)),
        runs_(outputs_.size()),
        shows_line_(jobs > 0),
        answers_(answers)
  {
  }

  /// Takes lines while there is room for their runs, and answers runs that have ended.
  void run()
  {
    for (;;)
    {
      answer_ended();
      const std::size_t place = place_of(-1);
      const bool takes = place < runs_.size() && !lines_.is_at_end() && !is_batch_interrupted();
      if (takes)
        if (const auto line = lines_.next())
        {
          begin(*line, place);
          continue;
        }
      if (!takes && std::all_of(runs_.begin(), runs_.end(), [](const Run &one) { return one.child < 0; }))
        return;
      if (wait_for_input_or_signal(takes))
        lines_.read();
    }
  }

private:
  struct Run
  {
    pid_t child = -1; ///< -1: there is none
    unsigned long line = 0;
    double prepared_seconds = 0;
    Stopwatch watch{};
  };

  /// Of the run of this process; the number of runs where there is none.
  std::size_t place_of(const pid_t child) const
  {
    return static_cast<std::size_t>(
        std::find_if(runs_.begin(), runs_.end(), [&](const Run &run) { return run.child == child; }) -
        runs_.begin());
  }

  void begin(const std::string &line, const std::size_t place)
  {
    Run run{-1, ++n_lines_};
    const auto words = words_of(line);
    if (!words)
      return write(answer(static_cast<int>(ExitCode::wrong_input),
                          "orthocone: --batch: allowed is a JSON array of words in each line, such as "
                          "[\"FILE.prm\", \"--quiet\"]"),
                   run.line);
    outputs_[place].clear();
    start(*words, place, run);
    if (run.child < 0 && is_batch_interrupted())
      write(answer(static_cast<int>(ExitCode::interrupted), "orthocone: interrupted before the run began"),
            run.line);
    else if (run.child < 0)
      write(answer(static_cast<int>(ExitCode::unsolved_step), std::strerror(errno)), run.line);
    else
      runs_[place] = run;
  }

  /// Forks by the keeper where it can, and else from here: without a keeper a run takes longer, and is the
  /// same.
  void start(const std::vector<std::string> &words, const std::size_t place, Run &run)
  {
    if (!outputs_[place].is_there())
      return;
    if (has_keeper_ && program_.can_prepare(words))
    {
      if (!keeper_)
        keeper_.emplace(program_.prepare, program_.run, outputs_);
      if (const auto started = keeper_->start(words, place))
      {
        run.child = started->child;
        run.prepared_seconds = started->cpu_seconds;
        return;
      }
      has_keeper_ = false;
      keeper_.reset();
      if (is_batch_interrupted())
        return; // Ctrl-C has ended the keeper, and would have ended the run
    }
    run.child = ::fork();
    if (run.child == 0)
      run_as_child(words, outputs_[place], program_.run);
  }

  void answer_ended()
  {
    constexpr int signal_base = 128; // as shells do
    for (std::size_t place = 0; place < runs_.size(); ++place)
    {
      int status = 0;
      rusage usage{};
      Run &run = runs_[place];
      if (run.child < 0 || ::wait4(run.child, &status, WNOHANG, &usage) != run.child)
        continue;
      Json json = answer(WIFEXITED(status) ? WEXITSTATUS(status) : signal_base + WTERMSIG(status),
                         outputs_[place].errors());
      json["cpu_seconds"] = seconds(usage.ru_utime) + seconds(usage.ru_stime) + run.prepared_seconds;
      json["seconds"] = run.watch.seconds();
      json["output"] = outputs_[place].output();
      run.child = -1;
      write(json, run.line);
    }
  }

  void write(Json json, const unsigned long line)
  {
    if (shows_line_)
      json["line"] = line;
    answers_ << json.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
    if (!answers_)
      throw FileError("standard output: cannot be written");
  }

  const BatchProgram &program_;
  const std::deque<ChildOutput> outputs_;
  std::vector<Run> runs_; ///< one for each output
  const bool shows_line_;
  std::ostream &answers_;
  InputLines lines_{};
  unsigned long n_lines_ = 0;
  bool has_keeper_ = true; ///< until one has failed
  std::optional<Keeper> keeper_{};
};
} // namespace

bool run_batch(const BatchProgram &program, const unsigned int jobs, std::ostream &answers)
{
  hold_signals();
  Batch(program, jobs, answers).run();
  return !is_batch_interrupted();
}
} // namespace orthocone
