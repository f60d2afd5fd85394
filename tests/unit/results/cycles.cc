// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Many cycles: when the response is periodic, and what jumping over cycles leaves.
#include "results/scenes.h"

#include <orthocone/results/cycles.h>
#include <orthocone/scene/parameters.h>

namespace orthocone::test
{
using Eigen::Index;

namespace
{
/// A small scene that unloads to a fifth and so keeps a history.
Parameters partly_unloaded(const std::array<double, 2> &p, const unsigned int cycles)
{
  Parameters parameters = small_scene(1);
  parameters.friction.slip_potential = p;
  parameters.load.legs = {move_to(0, 0, -0.1, 3), move_to(0, 0, -0.02, 4)};
  parameters.load.cycles = cycles;
  return parameters;
}

/// Marches a scene with a watch over its cycles; jumps if the watch says so.
class WatchedScene
{
public:
  explicit WatchedScene(const Parameters &parameters)
      : scene(parameters),
        watch(parameters.load, scene.shares, scene.scene.pressed_areas())
  {
    StepSolver solver(scene.scene);
    Totals totals;
    for (const LoadStep &step : LoadProgram(parameters.load).steps())
      if (step.number > scene.state.step && !watch.is_to_stop())
      {
        const ContactState before = scene.state;
        const SolverReport report = solver.solve(scene.state, step);
        EXPECT_TRUE(report.converged);
        solver.accept(before, scene.state, step);
        states.push_back(scene.state);
        const Totals after = scene.totals();
        if (const auto row = watch.add_step(step, before, {scene.state, totals, after, report, {}, 0}))
          end_cycle(*row);
        totals = scene.totals();
      }
  }

  TestScene scene;
  CycleWatch watch;
  std::vector<CycleRow> rows;
  std::vector<ContactState> states; ///< after every computed step

private:
  void end_cycle(const CycleRow &row)
  {
    rows.push_back(row);
    if (const unsigned int n = watch.n_to_jump(); n > 0)
      rows.push_back(watch.jump_cycles(scene.state, n));
  }
};

/// A state of two nodes with numbers that are easy to follow.
ContactState two_nodes()
{
  ContactState state(2);
  state.force << 3, 4, 0, 0, 0, 0;
  state.displacement << 0, 0.01, 0, 0.02, 0, 0;
  state.accumulated_slip << 1, 2;
  state.dissipated_energy << 10, 30;
  state.motion = moved_by(0, 0, -0.1);
  state.step = 20;
  return state;
}
} // namespace

TEST(Cycles, ChangeIsTheLargestOfForcesAndMotions)
{
  const ContactState start = two_nodes();
  const Eigen::Vector2d shares(1, 0.5); // the second node is on a plane of symmetry
  EXPECT_EQ(change_of_state(start, start, shares, 5, 0.1), 0);
  ContactState end = start;
  end.force[3] += 0.015; // node 1 along n
  end.force[4] += 0.02;
  EXPECT_NEAR(change_of_state(start, end, shares, 5, 0.1), 0.01, 1e-15);
  end.displacement[2] += 0.002;
  EXPECT_NEAR(change_of_state(start, end, shares, 5, 0.1), 0.02, 1e-15);
  end.motion[0] = 0.01;
  EXPECT_NEAR(change_of_state(start, end, shares, 5, 0.1), 0.1, 1e-15);
  end.motion[3] = 0.0012; // rad; moves a node at most 20 mm from the centre by 0.024 mm
  EXPECT_NEAR(change_of_state(start, end, shares, 5, 0.1, 20), 0.24, 1e-15);
  // What only adds up does not matter to the next cycle.
  end = start;
  end.accumulated_slip[0] += 1;
  end.dissipated_energy[1] += 1;
  end.step += 5;
  EXPECT_EQ(change_of_state(start, end, shares, 5, 0.1), 0);
}

// Loads alone drive a press fit, or a body under pressure. A change that is infinite stopped --resume.
TEST(Cycles, ForcesDecideWhereNothingMovesTheFace)
{
  ContactState start = two_nodes();
  start.motion = {};
  ContactState end = start;
  end.displacement[2] += 0.002;
  EXPECT_EQ(change_of_state(start, end, Eigen::Vector2d(1, 1), 5, 0), 0);
  end.force[0] += 0.05;
  EXPECT_NEAR(change_of_state(start, end, Eigen::Vector2d(1, 1), 5, 0), 0.01, 1e-15);
}

TEST(Cycles, AJumpAddsTheLastCycleSoManyTimes)
{
  const ContactState start = two_nodes();
  ContactState end = start;
  end.accumulated_slip << 1.5, 2;
  end.dissipated_energy << 11, 34;
  end.step = 25;
  const ContactState before = end;
  jump(end, start, 100, 5);
  EXPECT_EQ(end.accumulated_slip, Eigen::Vector2d(51.5, 2));
  EXPECT_EQ(end.dissipated_energy, Eigen::Vector2d(111, 434));
  EXPECT_EQ(end.step, 525u);
  EXPECT_EQ(end.force, before.force);
  EXPECT_EQ(end.displacement, before.displacement);
  EXPECT_EQ(end.motion, before.motion);
}

// Full unloading leaves nothing: the first cycle ends as it began, and the others are like it.
TEST(Cycles, FullUnloadingIsPeriodicFromTheFirstCycle)
{
  for (const auto &p : slip_ellipses)
  {
    Parameters parameters = small_scene(1);
    parameters.friction.slip_potential = p;
    parameters.load.cycles = 2;
    parameters.load.jump_when_periodic = 1e-8;
    const WatchedScene watched(parameters);
    ASSERT_EQ(watched.rows.size(), 2u); // there is nothing to jump: the last cycle is computed
    EXPECT_LE(watched.rows[0].change, 1e-12);
    EXPECT_EQ(watched.watch.memory().periodic_since, 1u);
    EXPECT_NEAR(watched.rows[1].dissipation / watched.rows[0].dissipation, 1, 1e-8);
    EXPECT_GT(watched.rows[0].peak_force_z, 0);
    EXPECT_EQ(watched.rows[0].force_z, 0);
    EXPECT_EQ(watched.rows[0].last_step, 15u);
  }
}

TEST(Cycles, TheFirstCycleIsNotPeriodicIfItBeganElsewhere)
{
  const WatchedScene watched(partly_unloaded(slip_ellipses[0], 3));
  ASSERT_EQ(watched.rows.size(), 3u);
  EXPECT_GE(watched.rows[0].change, 0.2 * (1 - 1e-12)); // the top alone
  EXPECT_LT(watched.rows[1].change, 0.1);
  EXPECT_GT(watched.rows[1].change, 1e-6);
}

// The end of a cycle is all that the next one knows: cycles that begin alike are alike at every step.
TEST(Cycles, WhatBeginsAlikeStaysAlike)
{
  for (const auto &p : slip_ellipses)
  {
    const WatchedScene watched(partly_unloaded(p, 12));
    const unsigned int n = 7;
    for (std::size_t cycle = 2; cycle + 1 < watched.rows.size(); ++cycle)
    {
      const double change = watched.rows[cycle].change;
      double largest_force = 0;
      for (const ContactState &state : watched.states)
        largest_force = std::max(largest_force, state.force.norm());
      for (std::size_t i = cycle * n; i < (cycle + 1) * n; ++i)
      {
        const double later = change_of_state(watched.states[i], watched.states[i + n], watched.scene.shares,
                                             largest_force, 0.1);
        EXPECT_LE(later, 10 * change + 1e-10) << "cycle " << cycle + 1 << " step " << i + 1;
      }
    }
  }
}

TEST(Cycles, StopEndsTheRunAtTheFirstPeriodicCycle)
{
  Parameters parameters = partly_unloaded(slip_ellipses[0], 40);
  const WatchedScene whole(parameters);
  DeclaredParameters declared(parameters);
  assign_entry("Load program/Stop when periodic=1e-4", declared.list);
  const WatchedScene stopped(declared.parameters);
  ASSERT_LT(stopped.rows.size(), whole.rows.size());
  for (std::size_t i = 0; i < stopped.rows.size(); ++i)
    EXPECT_EQ(whole.rows[i].change <= 1e-4, i + 1 == stopped.rows.size()) << "cycle " << i + 1;
  EXPECT_EQ(stopped.watch.memory().periodic_since, stopped.rows.size());
}

// After n jumped cycles the state is where it was, and drifts at most by n times the change of a cycle: so
// far may what has added up be wrong.
TEST(Cycles, JumpedCyclesAgreeWithComputedOnes)
{
  constexpr unsigned int n_cycles = 40;
  for (const auto &p : slip_ellipses)
    for (const unsigned int most : {5U, 1000U})
    {
      Parameters parameters = partly_unloaded(p, n_cycles);
      const WatchedScene computed(parameters);
      parameters.load.jump_when_periodic = 1e-4;
      parameters.load.jump_cycles = most;
      const WatchedScene jumped(parameters);
      EXPECT_LT(jumped.states.size(), computed.states.size());
      EXPECT_EQ(jumped.states.size() + jumped.watch.memory().n_jumped_steps(), computed.states.size());
      const ContactState &a = jumped.scene.state;
      const ContactState &b = computed.scene.state;
      EXPECT_EQ(a.step, b.step);
      EXPECT_EQ(jumped.rows.back().cycle, n_cycles);
      EXPECT_EQ(jumped.rows.back().n_cycles, 1u);
      const double bound = n_cycles * parameters.load.jump_when_periodic;
      EXPECT_LE((a.accumulated_slip - b.accumulated_slip).cwiseAbs().maxCoeff(),
                bound * b.accumulated_slip.maxCoeff());
      EXPECT_LE((a.dissipated_energy - b.dissipated_energy).cwiseAbs().maxCoeff(),
                bound * b.dissipated_energy.maxCoeff());
      EXPECT_LE((a.force - b.force).norm(), bound * b.force.norm());
      unsigned int cycles = 0;
      double slip = 0;
      for (const CycleRow &row : jumped.rows)
      {
        cycles += row.n_cycles;
        slip += row.accumulated_slip;
      }
      EXPECT_EQ(cycles, n_cycles);
      EXPECT_GE(slip, a.accumulated_slip.maxCoeff() * (1 - 1e-12));
    }
}

TEST(Cycles, RowsOfAllCyclesAddUp)
{
  const WatchedScene watched(partly_unloaded(slip_ellipses[1], 4));
  double dissipation = 0;
  for (const CycleRow &row : watched.rows)
  {
    dissipation += row.dissipation;
    EXPECT_NEAR(dissipation / row.total_dissipation, 1, 1e-12);
    EXPECT_GT(row.max_slip, 0);
    EXPECT_GT(row.accumulated_slip, 0);
    EXPECT_LE(row.accumulated_slip, row.max_accumulated_slip);
    EXPECT_GT(row.peak_force_z, row.force_z);
  }
}
} // namespace orthocone::test
