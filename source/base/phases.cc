// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/phases.h>

namespace orthocone
{
void PhaseSeconds::add(const PhaseSeconds &other)
{
  for (const auto &[name, phase] : phases)
    this->*phase += other.*phase;
}

double PhaseSeconds::sum() const
{
  double sum = 0;
  for (const auto &[name, phase] : phases)
    sum += this->*phase;
  return sum;
}
} // namespace orthocone
