// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A quarter of trilinear cells that multigrid knows no coarser ones of, factorized or aggregated, and what
// aggregates of the nodes of quadratic cells would be worth (docs/performance.md, "Large coarsest meshes").
// tools/study benchmark leaves them out.
#include "multigrid/coarse_solver.h"
#include "multigrid/elastic_solver.h"

#include <orthocone/body/shapes/body_mesh.h>
#include <orthocone/surface/local_axes.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <benchmark/benchmark.h>

#include <algorithm>

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

MeshOptions quadratic(MeshOptions mesh)
{
  mesh.degree = 2;
  return mesh;
}

/// Cells that get thin towards rim, base and upper face.
MeshOptions graded_cells()
{
  MeshOptions mesh;
  mesh.core_cells = 8;
  mesh.rings = 5;
  mesh.rim_grading = 0.5;
  mesh.layers = 10;
  mesh.layer_grading = 0.33;
  return mesh;
}

struct Coarsest
{
  Coarsest(benchmark::State &state, const MeshOptions &options, const CoarseMethod method)
      : mesh(options),
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
    benchmark::DoNotOptimize(
        Coarsest(state, even_cells(static_cast<unsigned int>(state.range(0))), method).cycle.n_cycles());
}

/// In every iteration of Newton's method: a third of the nodes open, a third held, a third slipping.
void coarsest_hold(benchmark::State &state, const CoarseMethod method)
{
  Coarsest coarsest(state, even_cells(static_cast<unsigned int>(state.range(0))), method);
  std::vector<NodeRelation> relations(coarsest.space.contact_surface().nodes.size());
  for (std::size_t i = 0; i < relations.size(); ++i)
    relations[i].hold = i % 3 == 0 ? Hold::nothing : i % 3 == 1 ? Hold::all : Hold::normal;
  for (auto _ : state)
    coarsest.cycle.hold(relations);
}

/// In every V-cycle. The iterations are those of conjugate gradients, to eight digits.
void coarsest_solve(benchmark::State &state, const CoarseMethod method)
{
  Coarsest coarsest(state, even_cells(static_cast<unsigned int>(state.range(0))), method);
  BodyVector<double> displacement = coarsest.forces;
  for (auto _ : state)
    coarsest.cycle.vmult(displacement, coarsest.forces);
  const unsigned long before = coarsest.cycle.n_cycles();
  ElasticSolver(coarsest.stiffness, coarsest.cycle).solve(coarsest.forces, 1e-8);
  state.counters["iterations"] = static_cast<double>(coarsest.cycle.n_cycles() - before);
}

/// Aggregates of all nodes as the only preconditioner.
struct Aggregates
{
  void vmult(BodyVector<double> &displacement, const BodyVector<double> &forces) const
  {
    const Eigen::VectorXd solution =
        coarse.solve(Eigen::Map<const Eigen::VectorXd>(forces.begin(), coarse_size));
    displacement = 0;
    std::copy(solution.begin(), solution.end(), displacement.begin());
  }
  const CoarseSolver &coarse;
  Eigen::Index coarse_size;
};

template<typename Preconditioner>
void solve(benchmark::State &state, const Coarsest &body, const Preconditioner &preconditioner)
{
  dealii::SolverControl control(200, 1e-8 * body.forces.l2_norm(), false, false);
  dealii::SolverCG<BodyVector<double>> cg(control);
  for (auto _ : state)
  {
    BodyVector<double> displacement = body.stiffness.make_vector();
    cg.solve(body.stiffness, displacement, body.forces, preconditioner);
  }
  state.counters["iterations"] = control.last_step();
}

/// Conjugate gradients to eight digits with trilinear elements as the coarser level.
void quadratic_by_levels(benchmark::State &state, const MeshOptions &mesh)
{
  const Coarsest body(state, quadratic(mesh), CoarseMethod::by_size);
  solve(state, body, body.cycle);
}

/// The same with the assembled stiffness of the quadratic elements.
void quadratic_by_aggregates(benchmark::State &state, const MeshOptions &mesh)
{
  const Coarsest body(state, quadratic(mesh), CoarseMethod::by_size);
  const auto coarse = make_coarse_solver(body.space, {}, CoarseMethod::algebraic);
  solve(state, body, Aggregates{*coarse, body.space.n_free()});
}

void sizes(benchmark::internal::Benchmark *const kernel)
{
  kernel->ArgName("half_cells")->Arg(8)->Arg(16)->Arg(20)->Arg(24);
  kernel->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK_CAPTURE(quadratic_by_levels, even, even_cells(6))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quadratic_by_aggregates, even, even_cells(6))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quadratic_by_levels, graded, graded_cells())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quadratic_by_aggregates, graded, graded_cells())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(coarsest_set_up, factorized, CoarseMethod::factorized)->Apply(sizes);
BENCHMARK_CAPTURE(coarsest_set_up, aggregated, CoarseMethod::algebraic)->Apply(sizes);
BENCHMARK_CAPTURE(coarsest_hold, factorized, CoarseMethod::factorized)->Apply(sizes);
BENCHMARK_CAPTURE(coarsest_hold, aggregated, CoarseMethod::algebraic)->Apply(sizes);
BENCHMARK_CAPTURE(coarsest_solve, factorized, CoarseMethod::factorized)->Apply(sizes);
BENCHMARK_CAPTURE(coarsest_solve, aggregated, CoarseMethod::algebraic)->Apply(sizes);
} // namespace
