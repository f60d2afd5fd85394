// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/load_steps.h>

#include <utility>

namespace orthocone
{
LoadSteps::LoadSteps(std::vector<LoadStep> different, const std::size_t n_cycle, const std::size_t size,
                     const double cycle_time, std::vector<Load> loads)
    : different_(std::move(different)),
      n_cycle_(n_cycle),
      size_(size),
      cycle_time_(cycle_time),
      loads_(std::move(loads))
{
}

LoadStep LoadSteps::operator[](const std::size_t i) const
{
  if (i < different_.size())
    return different_[i];
  const std::size_t behind = i - different_.size();
  LoadStep step = different_[different_.size() - n_cycle_ + behind % n_cycle_];
  step.number = static_cast<unsigned int>(i + 1);
  const auto repetition = static_cast<unsigned int>(1 + behind / n_cycle_);
  step.cycle += repetition;
  if (step.time)
    *step.time += repetition * cycle_time_;
  for (LoadStep &part : step.parts)
  {
    part.number = step.number;
    part.cycle = step.cycle;
  }
  return step;
}
} // namespace orthocone
