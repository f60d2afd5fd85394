// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/load_program.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace orthocone
{
namespace
{
/// Point between the ends of a leg, with the 15 digits that a user would write: -0.06, not
/// -0.06000000000000001.
double between(const double start, const double end, const double share)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.15g", start + (end - start) * share);
  const double position = std::strtod(text.data(), nullptr);
  // The last digits of a difference are rounding: 0.1 - 0.07 is not 0.03.
  constexpr double rounding = 1e-15;
  return std::abs(position) < rounding * std::max(std::abs(start), std::abs(end)) ? 0 : position;
}

/// Appends the steps of `legs`, the first of which starts where the last step ended.
void append(const std::vector<Leg> &legs, const unsigned int cycle, std::vector<LoadStep> &steps)
{
  std::array<double, 3> start = steps.empty() ? std::array<double, 3>{} : steps.back().top;
  unsigned int phase = 0;
  for (const Leg &leg : legs)
  {
    for (unsigned int k = 1; k <= leg.steps; ++k)
    {
      LoadStep step{leg.target, static_cast<unsigned int>(steps.size()) + 1, k, cycle, phase++};
      if (k < leg.steps)
        for (unsigned int d = 0; d < 3; ++d)
          step.top[d] = between(start[d], leg.target[d], static_cast<double>(k) / leg.steps);
      steps.push_back(step);
    }
    start = leg.target;
  }
}
} // namespace

std::vector<LoadStep> load_steps(const LoadOptions &load)
{
  std::vector<LoadStep> steps;
  append(load.preload, 0, steps);
  for (unsigned int cycle = 1; cycle <= load.cycles; ++cycle)
    append(load.legs, cycle, steps);
  return steps;
}

double largest_motion(const LoadOptions &load, const unsigned int direction)
{
  double largest = 0;
  for (const auto *const legs : {&load.preload, &load.legs})
    for (const Leg &leg : *legs)
      largest = std::max(largest, std::abs(leg.target[direction]));
  return largest;
}
} // namespace orthocone
