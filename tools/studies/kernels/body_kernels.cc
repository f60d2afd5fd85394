// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The elastic body: what a linear elastic solve costs, and what condensation adds.
#include "multigrid/matrix_free_stiffness.h"
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

/// Forces by displacements: with the entries of the stiffness, and without them, as multigrid does it.
void assembled_product(benchmark::State &state)
{
  const Scene &s = scene_of(state);
  const Eigen::VectorXd displacement = Eigen::VectorXd::LinSpaced(s.discretization.n_free(), 1, 2);
  for (auto _ : state)
    benchmark::DoNotOptimize(s.stiffness.vmult(displacement).data());
}
BENCHMARK(assembled_product)->Apply(all_sizes);

template<typename Number>
void matrix_free_product(benchmark::State &state, const Number one)
{
  const Scene &s = scene_of(state);
  const MatrixFreeStiffness<Number> stiffness(s.discretization, s.parameters.material);
  BodyVector<Number> displacement = stiffness.make_vector(), forces = displacement;
  std::fill_n(displacement.begin(), s.discretization.n_free(), one);
  for (auto _ : state)
    stiffness.vmult(forces, displacement);
  benchmark::DoNotOptimize(forces.begin());
}
BENCHMARK_CAPTURE(matrix_free_product, single, 1.F)->Apply(all_sizes);
BENCHMARK_CAPTURE(matrix_free_product, double, 1.)->Apply(all_sizes);
} // namespace
