// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/coarser_march.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
namespace
{
Parameters coarser(Parameters parameters)
{
  constexpr double tolerance = 1e-4; // tighter changes nothing on the finer mesh
  MeshOptions &mesh = parameters.mesh;
  if (!mesh.refined_cells.empty())
    ++mesh.coarsenings;
  else if (mesh.refinements > 0)
    --mesh.refinements;
  else
    for (const unsigned int d : {0, 1})
      mesh.cells[d] /= 2;
  parameters.contact_solver.tolerance = tolerance;
  return parameters;
}

/// Whether a scene has a coarser mesh, or a coarser grid that is worth a march.
bool can_be_coarser(const Scene &scene)
{
  constexpr Eigen::Index least = 64; // patches along a side
  const Parameters &parameters = scene.parameters();
  if (scene.body().mesh().has_mesh())
    return parameters.mesh.backend == BodyBackend::multigrid && scene.body().mesh().n_levels() > 1;
  const SurfaceGrid grid = surface_grid(parameters.geometry, parameters.mesh);
  return grid.n_x % 2 == 0 && grid.n_y % 2 == 0 && std::min(grid.n_x, grid.n_y) >= least;
}

/// Forces (3 n, N) in global axes.
Eigen::VectorXd in_global_axes(const ContactFrame &frame, Eigen::VectorXd force)
{
  for (Eigen::Index node = 0; 3 * node < force.size(); ++node)
    force.segment<3>(3 * node) =
        frame.global_in_local(static_cast<std::size_t>(node)) * force.segment<3>(3 * node).eval();
  return force;
}
} // namespace

std::unique_ptr<CoarserMarch> CoarserMarch::of(const Scene &finer)
{
  if (finer.parameters().wear.wears())
    return nullptr; // it would have wear of its own, without the jumps
  const FrictionOptions &friction = finer.parameters().friction;
  if (friction.has_factor() && !friction.factor.is_constant())
    return nullptr; // likewise, and its factor may be no number where that of the finer mesh is one
  if (!can_be_coarser(finer))
    return nullptr;
  return std::make_unique<CoarserMarch>(coarser(finer.parameters()), finer.choice());
}

CoarserMarch::CoarserMarch(const Parameters &parameters, const ModelChoice &choice)
    : scene_(parameters, choice),
      solver_(scene_),
      state_(scene_.gaps(), scene_.n_loads())
{
}

std::optional<CoarserMarch::Change> CoarserMarch::solve(const LoadStep &step)
{
  ContactState next = state_;
  solved_.reset();
  if (!solver_.solve(next, step).converged)
    return std::nullopt;
  const ElasticBody &body = scene_.body();
  Change change;
  if (body.mesh().has_mesh())
    change.displacement = body.elastic_displacement(next.force) - body.elastic_displacement(state_.force);
  else
    change.force = in_global_axes(body.frame(), next.force - state_.force);
  change.motion.components = next.motion.components - state_.motion.components;
  change.loads = next.loads - state_.loads;
  solved_ = std::move(next);
  return change;
}

void CoarserMarch::accept(const LoadStep &step)
{
  if (!solved_)
    return;
  solver_.accept(state_, *solved_, step);
  state_ = *std::move(solved_);
  solved_.reset();
}

void CoarserMarch::restore(const MarchMemory &memory)
{
  state_ = memory.state;
  solver_.restore(memory.starts);
}
} // namespace orthocone
