// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <orthocone/results/mismatch_memory.h>

#include <vector>

namespace orthocone::test
{
namespace
{
constexpr double bound = 1e-8;

void expect_same_bits(const BodyMismatch &a, const BodyMismatch &b)
{
  EXPECT_EQ(a.unbalanced, b.unbalanced);
  EXPECT_EQ(a.displacement, b.displacement);
  EXPECT_TRUE(a.volume == b.volume);
}

/// Different forces that press the body, and the displacements that they cause.
std::vector<std::pair<NodeVector, NodeVector>> some_states(const ElasticBody &body, const unsigned int n)
{
  std::vector<std::pair<NodeVector, NodeVector>> states;
  for (unsigned int k = 1; k <= n; ++k)
  {
    const NodeVector force =
        NodeVector::LinSpaced(3 * static_cast<Eigen::Index>(body.surface().nodes.size()), 1, 1 + k);
    NodeVector elastic;
    body.compliance().vmult(elastic, force);
    states.emplace_back(force, elastic);
  }
  return states;
}
} // namespace

TEST(MismatchMemory, HasTheBitsOfTheBodyAndSolvesForForcesOnce)
{
  const TestScene scene(small_scene());
  MismatchMemory memory(scene.condensed);
  const auto states = some_states(scene.condensed, 3);
  for (const char *const pass : {"first", "second"})
  {
    SCOPED_TRACE(pass);
    for (const auto &[force, elastic] : states)
      expect_same_bits(memory.of(force, elastic, bound), scene.condensed.mismatch(force, elastic, bound));
    EXPECT_EQ(memory.n_solved(), states.size());
  }
}

// The last digit of one force asks for another solve, and other displacements are found at once.
TEST(MismatchMemory, TakesNoStateForAnother)
{
  const TestScene scene(small_scene());
  MismatchMemory memory(scene.condensed);
  const auto [force, elastic] = some_states(scene.condensed, 1).front();
  memory.of(force, elastic, bound);
  for (const Eigen::Index changed : {Eigen::Index{0}, force.size() - 1})
  {
    NodeVector other_force = force, moved = elastic;
    other_force[changed] = std::nextafter(force[changed], 2 * force[changed]);
    moved[changed] += 1e-3;
    expect_same_bits(memory.of(other_force, elastic, bound),
                     scene.condensed.mismatch(other_force, elastic, bound));
    EXPECT_GE(memory.of(force, moved, bound).displacement, 0.9e-3);
    expect_same_bits(memory.of(force, moved, bound), scene.condensed.mismatch(force, moved, bound));
  }
  EXPECT_EQ(memory.n_solved(), 3U);
}

TEST(MismatchMemory, ForgetsWhatWasAskedForLongestAgo)
{
  const TestScene scene(small_scene());
  const auto states = some_states(scene.condensed, 3);
  const std::size_t bytes_of_one =
      sizeof(double) * static_cast<std::size_t>(
                           states[0].first.size() +
                           scene.condensed.mismatch(states[0].first, states[0].second, bound).volume.size());
  const auto ask = [&](MismatchMemory &memory, const unsigned int which)
  { return memory.of(states[which].first, states[which].second, bound); };
  MismatchMemory two(scene.condensed, 2 * bytes_of_one);
  for (const unsigned int which : {0, 1, 0, 2, 0})
    ask(two, which);
  EXPECT_EQ(two.n_kept(), 2U);
  EXPECT_EQ(two.n_solved(), 3U); // 0 stayed, because 1 was older
  ask(two, 1);
  EXPECT_EQ(two.n_solved(), 4U);
  MismatchMemory none(scene.condensed, bytes_of_one - 1);
  for (const unsigned int which : {0, 0})
    ask(none, which);
  EXPECT_EQ(none.n_solved(), 2U);
  EXPECT_EQ(none.n_kept(), 0U);
}

// The contact problem of a settled cycle is solved where it stands, and rounding does not move it: this is
// what makes a memory worth its room.
TEST(MismatchMemory, KnowsTheStatesOfASettledCycle)
{
  for (const auto &p : slip_ellipses)
    for (const double angle : {0., 20.})
    {
      Parameters parameters = full_scene();
      parameters.friction.slip_potential = p;
      parameters.friction.angle = angle;
      parameters.load.cycles = 4;
      parameters.load.legs = {move_to(0, 0, -0.1, 2), move_to(0.01, 0, -0.08, 2), move_to(0, 0, 0, 3)};
      TestScene scene(parameters);
      MismatchMemory memory(scene.condensed);
      std::vector<std::size_t> solved_in_cycle(parameters.load.cycles, 0);
      scene.march(
          [&](const ContactState &, const ContactState &after, const LoadStep &step)
          {
            const std::size_t before = memory.n_solved();
            const NodeVector elastic = unworn_displacement(after) - scene.scene.gaps() -
                                       scene.scene.driven_displacement(after.motion, {});
            memory.of(after.force, elastic, bound);
            solved_in_cycle.at(step.cycle - 1) += memory.n_solved() - before;
          });
      EXPECT_EQ(solved_in_cycle.front(), 7U) << p[0] << " " << angle;
      EXPECT_EQ(solved_in_cycle.back(), 0U) << p[0] << " " << angle;
    }
}
} // namespace orthocone::test
