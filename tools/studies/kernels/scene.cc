// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene.h"

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>

namespace orthocone::benchmarks
{
namespace
{
constexpr double peak = -0.1, released = -0.09; // mm

Parameters parameters_of(const unsigned int core_cells)
{
  Parameters parameters;
  parameters.mesh.core_cells = core_cells;
  parameters.mesh.layers = std::max(1U, core_cells / 2);
  return parameters;
}

SymmetryPlanes quarter()
{
  SymmetryPlanes planes;
  planes.normal_to_x = planes.normal_to_y = true;
  return planes;
}

OrthotropicFriction friction(const FrictionOptions &options)
{
  return {options.mu[0], options.mu[1], options.p()[0], options.p()[1]};
}
} // namespace

Scene::Scene(const unsigned int core_cells)
    : parameters(parameters_of(core_cells)),
      mesh(parameters.geometry, parameters.mesh, quarter()),
      discretization(mesh.triangulation(), parameters.mesh, parameters.geometry.top_face),
      stiffness(discretization, parameters.material),
      factor(stiffness.matrix(), discretization.n_interior()),
      condensed(discretization, factor, LocalAxes(parameters.friction.angle)),
      system(condensed.compliance(),
             FrictionLaws(condensed.compliance().n_nodes(), friction(parameters.friction))),
      problem(system, condensed.frame().moved_with(moved_by(0, 0, peak))),
      force(NodeVector::Zero(3 * problem.n_nodes()))
{
  press_and_release();
}

void Scene::press_and_release()
{
  // The first loading is proportional: one step does what five do.
  if (!make_contact_solver(system, parameters.contact_solver)->solve(problem, force).converged)
    throw std::runtime_error("the scene of the benchmark could not be loaded");
  const NodeVector at_peak = problem.displacement(force);
  problem =
      ContactStep(system, step_displacement(condensed.frame().moved_with(moved_by(0, 0, released)), at_peak));
}

const Scene &scene(const unsigned int core_cells)
{
  static std::map<unsigned int, std::unique_ptr<Scene>> scenes;
  std::unique_ptr<Scene> &entry = scenes[core_cells];
  if (!entry)
    entry = std::make_unique<Scene>(core_cells);
  return *entry;
}
} // namespace orthocone::benchmarks
