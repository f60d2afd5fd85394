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

/// The needs of a run, accurate to about a factor of 3.
struct Estimate
{
  double gigabytes;
  double set_up_seconds; ///< assembly, factorization, condensation
  double step_seconds;   ///< contact, checks and output of one step, on average
};

/// The estimate from a symbolic factorization and the speed of a small matrix product on this machine. Throws
/// TooLargeError as factorization_cost() does.
Estimate estimate(const Parameters &parameters, const Body &body, const ModelSymmetry &symmetry);

/// The same from the size alone, for a solid and a usual machine.
Estimate usual_estimate(const Parameters &parameters, const ModelSize &size, const ModelSymmetry &symmetry);

/// The same for Mesh/Backend = multigrid. It makes coarsest meshes of up to 200 000 cells to find the stretch
/// of their cells.
Estimate multigrid_estimate(const Parameters &parameters, const ModelSize &size,
                            const ModelSymmetry &symmetry);

/// The memory of multigrid alone, in GB, without making a mesh.
double multigrid_gigabytes(const Parameters &parameters, const ModelSize &size,
                           const ModelSymmetry &symmetry);

/// A lower bound for a model of which only the size is known: the memory and time of its stiffness and its
/// dense compliance.
Estimate least_estimate(const ModelSize &size);

/// The memory of least_estimate() alone, GB. It measures nothing.
double least_gigabytes(const ModelSize &size);

/// The memory that a run keeps for its steps, GB.
double step_gigabytes(const LoadOptions &load, double contact_nodes);

/// Time that writing fields of the whole body takes in a step, on average, s.
double volume_seconds_per_step(const OutputOptions &output, double dofs);

/// Numbers of steps that a run may compute, each counted with all its parts: all of them where no cycle is
/// jumped, and fewer where cycles are.
struct ComputedSteps
{
  double least, most;
};

/// The estimate in two lines, with the available memory. `is_least`: it is a lower bound.
std::string describe(const Estimate &estimate, const ComputedSteps &n_steps, const MemoryLimit &limit,
                     bool is_least);

/// Cells, unknowns and contact nodes in lines.
std::string describe(const ModelSize &size);
} // namespace orthocone
