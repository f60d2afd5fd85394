// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Mesh/Adaptive: cells are small only where the scene asks for it.
#pragma once

#include <orthocone/accuracy/step_search.h>
#include <orthocone/march/march.h>

#include <memory>
#include <vector>

namespace orthocone
{
/// Watches a first cycle and finds the cells that should be halved: cells at the rim of the contact surface;
/// cells on whose contact face some nodes stick and others slip, or some are open and others are not, at the
/// end of a leg; and the smallest set of cells with half of the estimated squared error at these ends
/// (docs/accuracy.md, "Cells halved where the scene asks for it").
class RefinementWatch : public MarchObserver
{
public:
  /// `scene` must outlive the watch.
  static std::unique_ptr<RefinementWatch> of(const Scene &scene);

  /// All ranks must call it.
  virtual std::vector<CellRange> cells_to_halve() const = 0;
};

/// The mesh of the parameters with as many rounds of refinement as its entry Adaptive says. In each round the
/// first cycle is solved, and the cells that RefinementWatch finds are halved. The result has the rounds in
/// Refined cells, and Adaptive is 0. The rounds end early where the next mesh is likely to need more memory
/// than `gigabytes`. `report` gets a line a round. Throws std::runtime_error if a step is not solved.
MeshOptions adapted_mesh(const Parameters &parameters, const ModelChoice &choice, const Reporter &report,
                         double gigabytes);
} // namespace orthocone
