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
/// Mesh and load steps of a run, and the results of choosing them.
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

/// Finds the mesh for Mesh/Accuracy. Solves level after level, at least three, until the estimated errors of
/// all quantities are as wanted, or there is no finer level, or the next one is likely to need more memory
/// than `gigabytes`. The levels are the mesh ladder; for a solid, levels from 2 on are level 1 with rounds of
/// refinement where RefinementWatch asks for them. `steps_share` is AccuracyEstimate::steps_share; finer
/// meshes do not have to make up for the part of it above `most_steps_share`. `report` gets a line a level.
/// Throws std::runtime_error if a step is not solved.
ChosenModel find_mesh(const Parameters &parameters, const ModelChoice &choice, const Reporter &report,
                      double gigabytes, const Quantities &steps_share = {}, double most_steps_share = 0);

/// Mesh and load steps that the parameters ask for, in whichever way. Where both have an accuracy, 0.3 times
/// the larger one is left to the steps, and the errors of both together are within the larger one. Throws
/// what find_mesh(), find_steps() and adapted_mesh() throw.
ChosenModel choose_mesh_and_steps(const Parameters &parameters, const ModelChoice &choice,
                                  const Reporter &report);
} // namespace orthocone
