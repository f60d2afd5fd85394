// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/load_step.h>

#include <cstddef>
#include <vector>

namespace orthocone
{
/// The steps of a load program, in order. Cycles repeat the second one to the last bit, so that the steps of
/// many cycles take no memory.
class LoadSteps
{
public:
  /// Makes one step after the other.
  class Iterator
  {
  public:
    Iterator(const LoadSteps &steps, const std::size_t i)
        : steps_(steps),
          i_(i)
    {
    }
    LoadStep operator*() const { return steps_[i_]; }
    Iterator &operator++()
    {
      ++i_;
      return *this;
    }
    bool operator!=(const Iterator &other) const { return i_ != other.i_; }

  private:
    const LoadSteps &steps_;
    std::size_t i_;
  };

  LoadSteps() = default;

  /// `different` has the preload, the first cycle and, if there is one, the second cycle, of `n_cycle` steps
  /// and `cycle_time` seconds each; `size` counts the steps of all cycles.
  LoadSteps(std::vector<LoadStep> different, std::size_t n_cycle, std::size_t size, double cycle_time,
            std::vector<Load> loads = {});

  std::size_t size() const { return size_; }

  /// Step `i`, counted from 0.
  LoadStep operator[](std::size_t i) const;
  LoadStep front() const { return (*this)[0]; }
  LoadStep back() const { return (*this)[size_ - 1]; }

  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

  /// Those that others repeat.
  const std::vector<LoadStep> &different() const { return different_; }

  /// The loads whose values LoadStep::loads are.
  const std::vector<Load> &loads() const { return loads_; }

private:
  std::vector<LoadStep> different_{};
  std::size_t n_cycle_ = 0;
  std::size_t size_ = 0;
  double cycle_time_ = 0;
  std::vector<Load> loads_{};
};
} // namespace orthocone
