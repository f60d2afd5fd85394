// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/step_solver.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
// A cycle of very many steps must not fill memory and disk with forces to start from.
TEST(StartForces, RememberABoundedNumberOfPhases)
{
  const ContactState state(1000);
  StartForces starts;
  for (unsigned int cycle = 1; cycle <= 2; ++cycle)
    for (unsigned int phase = 0; phase < 3000; ++phase)
      starts.remember(state, state, LoadStep{{}, phase + 1, 1, cycle, phase});
  const StartMemory &memory = starts.memory();
  EXPECT_GT(memory.of_phase.size(), 500u);
  EXPECT_EQ(memory.of_phase.size(), memory.drift.size());
  EXPECT_LE((memory.of_phase.size() + memory.drift.size()) * state.force.size() * sizeof(double),
            StartMemory::most_bytes);
}
} // namespace orthocone::test
