// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Checkpoints of small runs.
#pragma once

#include "results/scenes.h"

#include <orthocone/output/checkpoint.h>
#include <orthocone/scene/parameters.h>

namespace orthocone::test
{
inline CycleMemory cycles_after(const ContactState &state)
{
  CycleMemory cycles(state.n_nodes());
  cycles.start = state;
  cycles.start_dissipation = 1. / 3;
  cycles.largest_nodal_force = 2. / 7;
  cycles.largest_force = 3. / 7;
  cycles.row.cycle = 3;
  cycles.row.work = 0.1;
  cycles.n_completed = 2;
  cycles.change = 1. / 9;
  cycles.periodic_since = 1;
  cycles.jumped = {{16, 30}, {46, 60}};
  cycles.friction = {state.accumulated_slip, state.dissipated_energy, 7, 1, 1. / 13};
  return cycles;
}

/// The checkpoint that a run of a scene would write after its step `number`.
inline Checkpoint checkpoint_after(const unsigned int number, const Parameters &parameters = small_scene())
{
  TestScene scene(parameters);
  StepSolver solver(scene.scene);
  Checkpoint checkpoint;
  for (const LoadStep &step : LoadProgram(parameters.load).steps())
    if (step.number <= number)
    {
      const ContactState before = scene.state;
      const Totals totals = scene.totals();
      const SolverReport report = solver.solve(scene.state, step);
      EXPECT_TRUE(report.converged);
      solver.accept(before, scene.state, step);
      checkpoint.record.add_step(step.number, totals, scene.totals(), report, {});
    }
  checkpoint.parameters = entry_values(parameters);
  checkpoint.chosen = entry_values(parameters);
  checkpoint.record.accuracy =
      AccuracyEstimate{1, {{1, 2, 3, 4, 5}}, {{0.1, 0.2, 0.3, 0.4, 0.5}}, {{0, 0, 0.1}}};
  checkpoint.record.steps = StepAccuracy{{2, {{5, 4, 3, 2, 1}}, {{0.5}}, {}}, {{1e-6, 1e-7}}};
  checkpoint.program = "1.2.3 (abc)";
  checkpoint.tables = {{"history.csv", {1234, 0xfedcba98}}, {"probe-P.csv", {5, 7}}};
  checkpoint.fields = {{1, 2, 3, 5, 10, 15, 16}, {}, {{"P", {2, 4, 6}}, {"Q", {}}}};
  checkpoint.state = scene.state;
  checkpoint.state.friction_factor = Eigen::VectorXd::LinSpaced(scene.state.n_nodes(), 0.1, 3);
  checkpoint.state.slip_speed = Eigen::VectorXd::LinSpaced(scene.state.n_nodes(), 0, 1. / 3);
  checkpoint.record.largest_factor = {3, 2};
  checkpoint.starts = solver.memory();
  checkpoint.cycles = cycles_after(scene.state);
  checkpoint.record.energy_defect = {0.7, 2};
  checkpoint.record.missing = 1. / 11;
  checkpoint.record.seconds.contact = 0.1;
  checkpoint.record.total_seconds = 2. / 3;
  return checkpoint;
}
} // namespace orthocone::test
