// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The elastic body: what a linear elastic solve costs, and what condensation adds.
#include "sizes.h"

namespace
{
using namespace orthocone;
using namespace orthocone::benchmarks;

void assembly(benchmark::State &state)
{
  const Scene &s = scene_of(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(Stiffness(s.discretization, s.parameters.material).matrix().m());
}
BENCHMARK(assembly)->Apply(all_sizes);

/// As a linear elastic program would do it: all unknowns in METIS' order.
void factorization_free(benchmark::State &state)
{
  const Scene &s = scene_of(state);
  for (auto _ : state)
    StiffnessFactor(s.stiffness.matrix(), s.discretization.n_free());
}
BENCHMARK(factorization_free)->Apply(all_sizes);

/// As the program does it: the contact unknowns last.
void factorization(benchmark::State &state)
{
  const Scene &s = scene_of(state);
  for (auto _ : state)
    StiffnessFactor(s.stiffness.matrix(), s.discretization.n_interior());
}
BENCHMARK(factorization)->Apply(all_sizes);

void condensation(benchmark::State &state)
{
  const Scene &s = scene_of(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(CondensedBody(s.discretization, s.factor, LocalAxes(0)).compliance().n_nodes());
}
BENCHMARK(condensation)->Apply(all_sizes);

/// One solution with the factor.
void one_solve(benchmark::State &state)
{
  const Scene &s = scene_of(state);
  const Eigen::VectorXd right_side = Eigen::VectorXd::LinSpaced(s.discretization.n_free(), 1, 2);
  for (auto _ : state)
    benchmark::DoNotOptimize(s.factor.solve(right_side).data());
}
BENCHMARK(one_solve)->Apply(all_sizes);
} // namespace
