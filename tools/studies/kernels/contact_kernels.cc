// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What the contact solvers are made of, at the first step of unloading.
#include "contact/solvers/newton/linearization.h"
#include "contact/solvers/sweeps/gauss_seidel.h"
#include "sizes.h"

#include <array>

namespace
{
using namespace orthocone;
using namespace orthocone::benchmarks;

void residual(benchmark::State &state)
{
  const Scene &s = scene_of(state);
  // In turns: the last product with W is remembered.
  const std::array<NodeVector, 2> forces{{s.force, 0.99 * s.force}};
  std::size_t turn = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(s.problem.residual(forces[++turn % 2]));
}
BENCHMARK(residual)->Apply(all_sizes);

void sweep(benchmark::State &state)
{
  const Scene &s = scene_of(state);
  const GaussSeidel sweeps(s.system, s.parameters.contact_solver);
  for (auto _ : state)
  {
    NodeVector force = s.force;
    sweeps.sweep(s.problem, force, 1);
    benchmark::DoNotOptimize(force.data());
  }
}
BENCHMARK(sweep)->Apply(all_sizes);

/// One linearization of the natural map and its solution, at the forces that the first sweeps leave: at those
/// of the peak all nodes seem to be open.
void newton_iteration(benchmark::State &state)
{
  const Scene &s = scene_of(state);
  const GaussSeidel sweeps(s.system, s.parameters.contact_solver);
  NodeVector force = s.force;
  for (unsigned int i = 0; i < 10; ++i)
    sweeps.sweep(s.problem, force, 1);
  const NodeVector displacement = s.problem.displacement(force);
  const auto solver = s.condensed.compliance().condition_solver(s.system.softness());
  for (auto _ : state)
    benchmark::DoNotOptimize(newton_change(*solver, linearize(s.problem, force, displacement), 0.01));
}
BENCHMARK(newton_iteration)->Apply(all_sizes);

/// The whole step by the default method, from the forces of the peak.
void contact_step(benchmark::State &state)
{
  const Scene &s = scene_of(state);
  const auto solver = make_contact_solver(s.system, s.parameters.contact_solver);
  SolverReport report;
  for (auto _ : state)
  {
    NodeVector force = s.force;
    report = solver->solve(s.problem, force);
  }
  if (!report.converged)
    state.SkipWithError("the step did not converge");
  state.counters["solver_iterations"] = report.iterations;
}
BENCHMARK(contact_step)->Apply(all_sizes);
} // namespace
