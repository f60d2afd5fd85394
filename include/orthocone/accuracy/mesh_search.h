// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Accuracy on demand: the program is solved on finer and finer meshes until the differences between them show
// that the quantities that users look at are accurate enough.
#pragma once

#include <orthocone/accuracy/accuracy.h>
#include <orthocone/accuracy/step_search.h>
#include <orthocone/march/step_solver.h>

#include <memory>
#include <optional>

namespace orthocone
{
/// Mesh and load steps of a run, and what is known from choosing them.
struct ChosenModel
{
  Parameters given;
  Parameters parameters; ///< as solved: Resolution = custom, both Accuracies 0, steps in their parts
  std::optional<AccuracyEstimate> accuracy{}; ///< of the mesh, if a search chose it
  std::optional<StepAccuracy> steps{};        ///< of the load steps, if a search divided them
  double search_seconds = 0;                  ///< wall time
  std::unique_ptr<Scene> scene{};             ///< with these parameters, if there is one yet
  StartMemory starts{};                       ///< of the first cycle in it
};

/// Finds the mesh for Mesh/Accuracy: solves level after level, at least three, until the estimated errors of
/// all quantities are as wanted, or there is no finer one, or the next one is likely to need more memory than
/// `gigabytes`. Levels are those of the mesh ladder; of a solid, from level 2 on, level 1 with rounds of
/// refinement as RefinementWatch finds. `steps_share`: AccuracyEstimate::steps_share; what is more than
/// `most_steps_share`, no finer mesh has to make up for. Throws std::runtime_error.
ChosenModel find_mesh(const Parameters &parameters, const ModelChoice &choice, const Reporter &report,
                      double gigabytes, const Quantities &steps_share = {}, double most_steps_share = 0);

/// Mesh and load steps that the parameters ask for, whichever way. Where both have an accuracy, 0.3 times the
/// larger one is left to the steps, and the errors of both together are as small as that.
ChosenModel choose_mesh_and_steps(const Parameters &parameters, const ModelChoice &choice,
                                  const Reporter &report);
} // namespace orthocone
