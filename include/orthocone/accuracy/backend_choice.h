// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>
#include <orthocone/surface/model_symmetry.h>

#include <string>

namespace orthocone
{
/// The backend that solves the elastic body, and the line with the reason; it is empty where nothing is
/// compared.
struct BackendChoice
{
  BodyBackend backend;
  std::string reason{};
};

/// Whether multigrid can compute such a model at all.
bool multigrid_can(const Parameters &parameters, const ModelSymmetry &symmetry);

/// The backend of Mesh/Backend = auto: the faster one by estimates that know only the memory of this machine,
/// into which the factorization must fit. Where multigrid cannot compute a solid (it needs one isotropic
/// material, a rigid obstacle and Newton's method), the reason names the entry.
/// Nothing is compared for a section, nor where no cell is halved and the factorization fits and takes
/// seconds, nor where neither fits.
/// `parameters` have the resolved mesh.
BackendChoice choose_backend(const Parameters &parameters, const ModelSymmetry &symmetry, double gigabytes);
} // namespace orthocone
