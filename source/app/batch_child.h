// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace orthocone
{
/// Runs a command line, without the name of the program, and returns its exit code.
using Runner = std::function<int(const std::vector<std::string> &)>;

/// Files in memory, without names, that a child writes what it prints into, and that its batch reads. Every
/// process that is forked later has them, too.
class ChildOutput
{
public:
  ChildOutput();
  ~ChildOutput();
  ChildOutput(const ChildOutput &) = delete;
  ChildOutput &operator=(const ChildOutput &) = delete;

  bool is_there() const { return output_ >= 0 && errors_ >= 0; }

  /// Makes both files empty, for the next child.
  void clear() const;

  /// What was printed, each cut to a length that somebody would read.
  std::string output() const;
  std::string errors() const;

  /// Makes them standard output and standard error of this process.
  void take() const;

private:
  int output_, errors_;
};

/// Keeps SIGINT and SIGCHLD of this process back until wait_for_input_or_signal(), and takes note of SIGINT.
void hold_signals();

/// Waits until there is something to read from standard input, if `for_input`, a child ends, or SIGINT comes.
/// Returns whether there is something to read.
bool wait_for_input_or_signal(bool for_input);

/// Whether SIGINT came, also while it is kept back.
bool is_batch_interrupted();

/// Gives signals to this process, a child of the batch, as if there were no batch.
void release_signals();

/// Does the work of a child, and ends this process.
[[noreturn]] void run_as_child(const std::vector<std::string> &words, const ChildOutput &files,
                               const Runner &run);
} // namespace orthocone
