// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Mesh/Adaptive: cells that are as small as the scene asks for, where it does.
#pragma once

#include <orthocone/accuracy/step_search.h>
#include <orthocone/march/march.h>

#include <memory>
#include <vector>

namespace orthocone
{
/// Watches a first cycle for the cells that it asks to be halved: those at the rim of the contact surface,
/// those on whose contact face some nodes stick and others slip, or some are open and others are not, at the
/// end of a leg, and the fewest of all that have half of the estimated squared error at these ends.
class RefinementWatch : public MarchObserver
{
public:
  /// `scene` must outlive the watch.
  static std::unique_ptr<RefinementWatch> of(const Scene &scene);

  /// All ranks must ask.
  virtual std::vector<CellRange> cells_to_halve() const = 0;
};

/// The mesh of the parameters with so many rounds of refinement as its entry Adaptive says: the first cycle
/// is solved, and the cells are halved that RefinementWatch finds. The rounds stand in Refined cells;
/// Adaptive is 0. They end where the next mesh is likely to need more memory than `gigabytes`. Throws
/// std::runtime_error if a step is not solved.
MeshOptions adapted_mesh(const Parameters &parameters, const ModelChoice &choice, const Reporter &report,
                         double gigabytes);
} // namespace orthocone
