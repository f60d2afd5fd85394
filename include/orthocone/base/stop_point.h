// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// How a signal stops an iteration that may take minutes, without the iteration's knowing of signals.
#pragma once

#include <exception>
#include <functional>

namespace orthocone
{
/// What was computed was stopped between two iterations. Whoever asked for it knows what to do then.
struct Stopped : std::exception
{
  const char *what() const noexcept override { return "stopped"; }
};

/// While one of these lives, stop_point() asks it, in this thread alone.
class Stoppable
{
public:
  /// `is_to_stop` must not throw; with several processes it must say the same in all of them.
  explicit Stoppable(std::function<bool()> is_to_stop);
  ~Stoppable();
  Stoppable(const Stoppable &) = delete;
  Stoppable &operator=(const Stoppable &) = delete;

private:
  friend void stop_point();
  std::function<bool()> is_to_stop_;
  const Stoppable *before_;
};

/// Throws Stopped if the work of this thread is to stop. Iterations call it once each; all processes must.
void stop_point();
} // namespace orthocone
