// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/coarser_march.h>

#include <utility>

namespace orthocone
{
namespace
{
Parameters coarser(Parameters parameters)
{
  constexpr double tolerance = 1e-4; // tighter changes nothing on the finer mesh
  MeshOptions &mesh = parameters.mesh;
  mesh.refined_cells.empty() ? --mesh.refinements : ++mesh.coarsenings;
  parameters.contact_solver.tolerance = tolerance;
  return parameters;
}
} // namespace

std::unique_ptr<CoarserMarch> CoarserMarch::of(const Scene &finer)
{
  const MeshOptions &mesh = finer.parameters().mesh;
  if (finer.parameters().wear.wears())
    return nullptr; // it would have wear of its own, without the jumps
  const FrictionOptions &friction = finer.parameters().friction;
  if (friction.has_factor() && !friction.factor.is_constant())
    return nullptr; // likewise, and its factor may be no number where that of the finer mesh is one
  if (mesh.backend != BodyBackend::multigrid || finer.body().mesh().n_levels() == 1)
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
  Change change{
      scene_.body().elastic_displacement(next.force) - scene_.body().elastic_displacement(state_.force), {}};
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
