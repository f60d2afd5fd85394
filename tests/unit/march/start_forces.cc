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

// A body is far larger than its forces: few phases have one, and only those where the last states do not give
// it.
TEST(StartForces, RememberABoundedNumberOfBodies)
{
  const ContactState state(10);
  constexpr unsigned int n_phases = 100, cheap = 5;
  const Eigen::VectorXd body = Eigen::VectorXd::Ones(1000000);
  StartForces starts;
  for (unsigned int cycle = 1; cycle <= 2; ++cycle)
    for (unsigned int phase = 0; phase < n_phases; ++phase)
    {
      const LoadStep step{{}, phase + 1, 1, cycle, phase};
      starts.remember(state, state, step);
      starts.keep({cycle * body}, {});
      starts.keep_body(step, cycle == 1 && phase != cheap);
    }
  const StartMemory &memory = starts.memory();
  EXPECT_EQ(memory.body_of_phase.size(), StartMemory::most_body_bytes / (body.size() * sizeof(double)));
  EXPECT_EQ(memory.body_of_phase.count(cheap), 0u);
  for (const auto &[phase, kept] : memory.body_of_phase)
    EXPECT_EQ(kept[0], 2) << phase; // of the last cycle
}
} // namespace orthocone::test
