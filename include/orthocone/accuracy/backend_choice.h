// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>
#include <orthocone/surface/model_symmetry.h>

#include <string>

namespace orthocone
{
/// Who solves the elastic body, and the line that says why; none where nothing was compared.
struct BackendChoice
{
  BodyBackend backend;
  std::string reason{};
};

/// Whether multigrid can compute such a model at all.
bool multigrid_can(const Parameters &parameters, const ModelSymmetry &symmetry);

/// What Mesh/Backend = auto stands for: what takes less time by estimates that know nothing of this machine
/// but its memory, which the factorization must fit into. Nothing is compared where only one can do it
/// (multigrid needs a solid, one isotropic material, full quadrature, Newton's method and a Poisson ratio
/// below 0.495), nor where no cell is halved and the factorization fits and takes seconds, or neither fits.
/// `parameters` have the resolved mesh.
BackendChoice choose_backend(const Parameters &parameters, const ModelSymmetry &symmetry, double gigabytes);
} // namespace orthocone
