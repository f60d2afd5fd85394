// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Accuracy on demand: the program is solved on finer and finer meshes until the differences between them tell
// that the quantities that users look at are accurate enough.
#pragma once

#include <orthocone/accuracy/accuracy.h>
#include <orthocone/march/step_solver.h>

#include <functional>
#include <memory>
#include <optional>

namespace orthocone
{
/// The quantities of the load program of a scene, by a solver of it. Throws std::runtime_error if a step is
/// not solved.
Quantities march_first_cycle(const Scene &scene, StepSolver &solver);

/// The mesh of a run, and what is known from choosing it.
struct ChosenMesh
{
  MeshOptions requested; ///< as given
  MeshOptions mesh;      ///< as meshed: Resolution = custom, Accuracy = 0
  std::optional<AccuracyEstimate> accuracy{};
  double search_seconds = 0;      ///< wall time
  std::unique_ptr<Scene> scene{}; ///< on that mesh, if there is one yet
  StartMemory starts{};           ///< of the first cycle on it
};

/// Takes lines for screen and log.
using Teller = std::function<void(const std::string &)>;

/// Finds the mesh for Mesh/Accuracy: solves level after level of the mesh ladder, at least three, until the
/// estimated errors of all quantities are as wanted, or there is no finer one, or the next one is likely to
/// need more memory than `gigabytes`. Throws std::runtime_error.
ChosenMesh find_mesh(const Parameters &parameters, const ModelChoice &choice, const Teller &tell,
                     double gigabytes);

/// The mesh that the parameters ask for, whichever way.
ChosenMesh choose_mesh(const Parameters &parameters, const ModelChoice &choice, const Teller &tell);
} // namespace orthocone
