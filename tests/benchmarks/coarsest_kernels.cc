// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A quarter of trilinear cells that multigrid knows no coarser ones of, factorized or aggregated
// (docs/performance.md, "Large coarsest meshes"). tools/benchmark leaves them out.
#include "body/backends/multigrid/elastic_solver.h"

#include <orthocone/body/shapes/body_mesh.h>
#include <orthocone/surface/local_axes.h>

#include <benchmark/benchmark.h>

#include <array>

namespace
{
using namespace orthocone;

/// `half_cells`: cells along half of a side of the core; those of the ring are as many, all nearly cubes.
MeshOptions even_cells(const unsigned int half_cells)
{
  MeshOptions mesh;
  mesh.degree = 1;
  mesh.core_cells = mesh.layers = 2 * half_cells;
  mesh.rings = half_cells;
  mesh.core_ratio = 0.6;
  return mesh;
}

struct Coarsest
{
  Coarsest(benchmark::State &state, const CoarseMethod method)
      : mesh(even_cells(static_cast<unsigned int>(state.range(0)))),
        cells({}, mesh, {true, true}),
        space(cells.triangulation(), mesh, TopFace::clamped),
        stiffness(space, {}),
        cycle(space, mesh, {}, {}, method),
        forces(stiffness.make_vector())
  {
    for (const ContactNode &node : space.contact_surface().nodes)
      forces.local_element(node.dofs[2]) = node.area;
    state.counters["dofs"] = space.n_dofs();
    state.counters["contact_nodes"] = static_cast<double>(space.contact_surface().nodes.size());
  }

  MeshOptions mesh;
  BodyMesh cells;
  Discretization space;
  MatrixFreeStiffness<double> stiffness;
  VCycle cycle;
  BodyVector<double> forces;
};

/// With what is made of it: factor and compliance, or aggregates.
void coarsest_set_up(benchmark::State &state, const CoarseMethod method)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(Coarsest(state, method).cycle.n_cycles());
}

/// In every iteration of Newton's method: a third of the nodes open, a third held, a third slipping.
void coarsest_hold(benchmark::State &state, const CoarseMethod method)
{
  Coarsest coarsest(state, method);
  std::vector<NodeRelation> relations(coarsest.space.contact_surface().nodes.size());
  for (std::size_t i = 0; i < relations.size(); ++i)
    relations[i].hold = std::array{Hold::nothing, Hold::all, Hold::normal}[i % 3];
  for (auto _ : state)
    coarsest.cycle.hold(relations);
}

/// In every V-cycle. The iterations are those of conjugate gradients, to eight digits.
void coarsest_solve(benchmark::State &state, const CoarseMethod method)
{
  Coarsest coarsest(state, method);
  BodyVector<double> displacement = coarsest.forces;
  for (auto _ : state)
    coarsest.cycle.vmult(displacement, coarsest.forces);
  const unsigned long before = coarsest.cycle.n_cycles();
  ElasticSolver(coarsest.stiffness, coarsest.cycle).solve(coarsest.forces, 1e-8);
  state.counters["iterations"] = static_cast<double>(coarsest.cycle.n_cycles() - before);
}

void sizes(benchmark::internal::Benchmark *const kernel)
{
  kernel->ArgName("half_cells")->Arg(8)->Arg(16)->Arg(20)->Arg(24);
  kernel->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK_CAPTURE(coarsest_set_up, factorized, CoarseMethod::factorized)->Apply(sizes);
BENCHMARK_CAPTURE(coarsest_set_up, aggregated, CoarseMethod::algebraic)->Apply(sizes);
BENCHMARK_CAPTURE(coarsest_hold, factorized, CoarseMethod::factorized)->Apply(sizes);
BENCHMARK_CAPTURE(coarsest_hold, aggregated, CoarseMethod::algebraic)->Apply(sizes);
BENCHMARK_CAPTURE(coarsest_solve, factorized, CoarseMethod::factorized)->Apply(sizes);
BENCHMARK_CAPTURE(coarsest_solve, aggregated, CoarseMethod::algebraic)->Apply(sizes);
} // namespace
