// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/base/memory.h>
#include <orthocone/body/body.h>
#include <orthocone/body/shapes/shape.h>

#include <string>

namespace orthocone
{
/// Size of a model, found from the numbers of cells alone.
ModelSize model_size(const Parameters &parameters, const ModelSymmetry &symmetry);

/// What a run will need, to about a factor of 3.
struct Estimate
{
  double gigabytes;
  double set_up_seconds; ///< assembly, factorization, condensation
  double step_seconds;   ///< contact, checks and output of one step, on average
};

/// From a symbolic factorization and the speed of a small matrix product on this machine.
Estimate estimate(const Parameters &parameters, const Body &body, const ModelSymmetry &symmetry);

/// The same from the size alone, for a solid and a usual machine.
Estimate usual_estimate(const Parameters &parameters, const ModelSize &size, const ModelSymmetry &symmetry);

/// The same for Mesh/Backend = multigrid. Coarsest meshes of up to 200 000 cells are made, to see how far
/// their cells are from cubes.
Estimate multigrid_estimate(const Parameters &parameters, const ModelSize &size,
                            const ModelSymmetry &symmetry);

/// Its memory alone, without any mesh.
double multigrid_gigabytes(const Parameters &parameters, const ModelSize &size,
                           const ModelSymmetry &symmetry);

/// Estimate for a model of which nothing but its size is known: what its stiffness and its dense compliance
/// alone take.
Estimate least_estimate(const ModelSize &size);

/// What a run keeps of its steps, GB.
double step_gigabytes(const LoadOptions &load, double contact_nodes);

/// What writing fields of the whole body takes, on average.
double volume_seconds_per_step(const OutputOptions &output, double dofs);

/// The estimate in two lines, with the memory that there is. `is_least`: it is a bound from below.
/// `has_jumps`: cycles may be left out.
std::string describe(const Estimate &estimate, unsigned int n_steps, const MemoryLimit &limit, bool is_least,
                     bool has_jumps);

/// Cells, unknowns and contact nodes in lines.
std::string describe(const ModelSize &size);
} // namespace orthocone
