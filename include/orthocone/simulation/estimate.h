// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/simulation/body.h>

#include <string>

namespace orthocone
{
/// Size of a model, found from the numbers of cells alone.
struct ModelSize
{
  double cells;
  double contact_nodes;
  double dofs;
};

ModelSize model_size(const MeshOptions &mesh, const ModelSymmetry &symmetry);

/// What a run will need, to about a factor of 3.
struct Estimate
{
  double gigabytes;
  double set_up_seconds; ///< assembly, factorization, condensation
  double step_seconds;   ///< contact, checks and output of one step, on average
};

/// From a symbolic factorization and the speed of a small matrix product on this machine.
Estimate estimate(const Parameters &parameters, const Body &body, const ModelSymmetry &symmetry);

/// Memory of this machine.
double machine_gigabytes();

/// The estimate in two lines, with the memory of this machine.
std::string describe(const Estimate &estimate, unsigned int n_steps);

/// What can be said of a model that is too large to be meshed for an estimate: its dense compliance alone.
std::string describe(const ModelSize &size);
} // namespace orthocone
