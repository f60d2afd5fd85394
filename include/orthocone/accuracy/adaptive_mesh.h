// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Mesh/Adaptive: cells that are as small as the scene asks for, where it does.
#pragma once

#include <orthocone/accuracy/step_search.h>

namespace orthocone
{
/// The mesh of the parameters with so many rounds of refinement as its entry Adaptive says: the first cycle is
/// solved, and the cells are halved that have most of the estimated error at the ends of the legs, or on whose
/// contact face some nodes stick and others slip, or some are open and others are not. The rounds stand in
/// Refined cells; Adaptive is 0. They end where the next mesh is likely to need more memory than `gigabytes`.
/// Throws std::runtime_error if a step is not solved.
MeshOptions adapted_mesh(const Parameters &parameters, const ModelChoice &choice, const Teller &tell,
                         double gigabytes);
} // namespace orthocone
