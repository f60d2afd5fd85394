// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "batch_child.h"

#include <sys/types.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>

namespace orthocone
{
/// A process beside a batch that does beforehand what its children have in common, and then forks them, so
/// that they inherit it. The children are the batch's own all the same, whatever becomes of the keeper: it is
/// a process of its own so that its end costs no more than what it has prepared.
class Keeper
{
public:
  using Words = std::vector<std::string>;

  /// `prepare` is called in the keeper with the words of every child before that child is forked.
  Keeper(const std::function<void(const Words &)> &prepare, const Runner &run,
         const std::deque<ChildOutput> &outputs);
  ~Keeper(); ///< ends the process
  Keeper(const Keeper &) = delete;
  Keeper &operator=(const Keeper &) = delete;

  struct Started
  {
    pid_t child;
    double cpu_seconds; ///< of the preparation
  };

  /// A child of this process that runs the words, and prints into this one of the outputs. Nothing where the
  /// keeper is not there any more, or could not fork.
  std::optional<Started> start(const Words &words, std::size_t output);

private:
  pid_t keeper_ = -1;
  int socket_ = -1;
};
} // namespace orthocone
