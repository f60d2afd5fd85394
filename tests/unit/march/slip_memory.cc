// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/slip_memory.h>

#include <gtest/gtest.h>

#include <random>

namespace orthocone::test
{
namespace
{
using Eigen::Vector2d;

/// A node that has slipped by 1 mm and slips on by `change`; less than 1e-8 mm is nothing.
NodeStep slipping(const Vector2d &change)
{
  NodeStep step;
  step.before = step.found = NodeStatus::slip;
  step.slip = {1, 0};
  step.change = change;
  step.unresolved = 1e-8;
  return step;
}
} // namespace

TEST(SlipMemory, ANodeAtRestStaysWhatItWas)
{
  for (const NodeStatus before : {NodeStatus::stick, NodeStatus::slip})
    for (const NodeStatus found : {NodeStatus::stick, NodeStatus::slip})
    {
      NodeStep step = slipping({-1e-9, 2e-9});
      step.before = before;
      step.found = found;
      step.reserve = found == NodeStatus::stick ? 1e-9 : 0;
      EXPECT_EQ(status_behind(step), before);
      EXPECT_NEAR(slip_behind(step).norm(), 1, 2e-9);
      step.reserve = found == NodeStatus::stick ? 1e-7 : 0;
      step.change *= found == NodeStatus::slip ? 1e3 : 1;
      EXPECT_EQ(status_behind(step), found);
    }
  NodeStep opening = slipping({0.1, 0.1});
  opening.found = NodeStatus::open;
  EXPECT_EQ(status_behind(opening), NodeStatus::open);
}

TEST(SlipMemory, ForgetsWhatStuckTurnedRoundOrOpened)
{
  NodeStep step = slipping({0.1, 0});
  EXPECT_NEAR(slip_behind(step).norm(), 1.1, 1e-15);
  step.gap = 1e-3;
  EXPECT_NEAR(slip_behind(step).norm(), 0.1, 1e-15);
  step = slipping({-0.1, 0});
  EXPECT_NEAR(slip_behind(step).norm(), 0.1, 1e-15);
  step = slipping({0, 0.1});
  EXPECT_NEAR(slip_behind(step).norm(), std::hypot(1, 0.1), 1e-15);
  step = slipping({1e-9, 0});
  step.found = NodeStatus::stick;
  step.reserve = 1;
  EXPECT_EQ(slip_behind(step).norm(), 0);
}

/// Steps at random, many of them at rest, at the limit, or turned by right angles: no digit of them decides.
TEST(SlipMemory, IsContinuous)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> one(-1, 1);
  const auto draw = [&] { return std::pow(10, 3 * one(random) - 3) * one(random); };
  constexpr double small = 1e-13;
  for (unsigned int n = 0; n < 20000; ++n)
  {
    const bool sticks = n % 7 == 0;
    const double most = sticks ? 1e-9 : 1e-6; // mm; a node that sticks moves by what is unresolved at most
    NodeStep step = slipping({n % 3 == 0 ? 0 : most * draw(), n % 5 == 0 ? 0 : most * draw()});
    step.gap = n % 2 == 0 ? 0 : std::abs(1e-6 * draw());
    step.reserve = sticks ? std::abs(1e-5 * draw()) : 0;
    step.found = sticks ? NodeStatus::stick : NodeStatus::slip;
    NodeStep other = step;
    other.change += small * Vector2d(one(random), one(random));
    other.gap = std::max(0., step.gap + small * one(random));
    if (sticks && step.reserve < step.unresolved)
      other.found = NodeStatus::slip;
    constexpr double steepest = 1e8; // 1/1e-8 mm: slip fades over what is unresolved
    EXPECT_LE((slip_behind(other) - slip_behind(step)).norm(), 5 * steepest * small) << n;
  }
}

TEST(SlipMemory, ReserveIsThatOfTheCone)
{
  const OrthotropicFriction isotropic{0.3, 0.3, 0.3, 0.3};
  EXPECT_NEAR(friction_reserve(isotropic, {100, 0, 0}), 30, 1e-12);
  EXPECT_NEAR(friction_reserve(isotropic, {100, 6, 8}), 20, 1e-12);
  EXPECT_EQ(friction_reserve(isotropic, {100, 0, 31}), 0);
  EXPECT_EQ(friction_reserve(isotropic, {0, 0, 0}), 0);
  EXPECT_EQ(friction_reserve(OrthotropicFriction{0, 0, 1, 1}, {100, 0, 0}), 0);
  EXPECT_NEAR(friction_reserve(OrthotropicFriction{0.4, 0.1, 1, 1}, {100, 0, 5}), 0.5 * (5 + 0.5 * 20),
              1e-12);
}
} // namespace orthocone::test
