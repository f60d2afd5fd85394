// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/parameters/computed_steps.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
double solved_parts(const std::vector<Leg> &legs)
{
  double n = 0;
  for (const Leg &leg : legs)
    n += static_cast<double>(leg.steps) * leg.parts;
  return n;
}

double least_computed_cycles(const LoadOptions &load, const WearOptions &wear)
{
  const double n = load.cycles;
  // Behind a jump of wear one cycle settles, and the next one has the rate of the next jump. The last cycle
  // is always computed, in wear as in a response that is periodic.
  if (wear.law != WearKind::none && wear.largest_jump > 0)
    return std::min(n, 3.);
  if (load.jump_when_periodic > 0)
    return n == 0 ? 0 : 1 + std::ceil((n - 1) / (load.jump_cycles + 1.));
  return n;
}
} // namespace

bool may_jump(const LoadOptions &load, const WearOptions &wear)
{
  return load.jump_when_periodic > 0 || (wear.law != WearKind::none && wear.largest_jump > 0);
}

double least_computed_parts(const LoadOptions &load, const WearOptions &wear)
{
  return solved_parts(load.preload) + least_computed_cycles(load, wear) * solved_parts(load.legs);
}
} // namespace orthocone
