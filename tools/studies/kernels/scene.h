// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/backends/condensed_body.h>
#include <orthocone/body/fe/stiffness.h>
#include <orthocone/body/shapes/body_mesh.h>
#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/scene/parameters.h>

namespace orthocone::benchmarks
{
/// The paper's case B in a quarter of Q2 elements on `core_cells` (even), half as many layers; 8 is the
/// paper's mesh. The body is factorized and condensed; the contact problem is the first step of unloading.
class Scene
{
public:
  explicit Scene(unsigned int core_cells);

  Parameters parameters;
  BodyMesh mesh;
  Discretization discretization;
  Stiffness stiffness;
  StiffnessFactor factor;
  CondensedBody condensed;
  ContactSystem system;
  ContactStep problem;
  NodeVector force; ///< at the peak, from which the unloading step starts

private:
  void press_and_release();
};

/// The scene of that size; made when it is first asked for, and kept.
const Scene &scene(unsigned int core_cells);
} // namespace orthocone::benchmarks
