// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Memory and time of a run before it begins, and what follows from them: --check, --insist, Mesh/Backend.
#pragma once

#include <orthocone/base/machine.h>
#include <orthocone/body/body.h>
#include <orthocone/body/shapes/shape.h>

#include <string>

namespace orthocone
{
struct FactorizationCost;

/// The needs of a run, accurate to about a factor of 3.
struct Estimate
{
  double gigabytes;
  double set_up_seconds; ///< assembly, factorization, condensation
  double step_seconds;   ///< contact, checks and output of one step, on average

  double seconds(const double n_steps) const { return set_up_seconds + n_steps * step_seconds; }
};

/// The cost of a model by its size: sums of products of powers of the numbers of unknowns and contact nodes,
/// with the constants of cost_constants.h.
class CostModel
{
public:
  /// Finds the size from the numbers of cells alone, unless single cells are halved: then it makes the mesh,
  /// and throws what Body throws. `parameters` have the resolved mesh, and must outlive this.
  CostModel(const Parameters &parameters, const ModelSymmetry &symmetry);
  /// With a size that is known.
  CostModel(const Parameters &parameters, const ModelSymmetry &symmetry, const ModelSize &size);

  const ModelSize &size() const { return size_; }

  /// The factorized body, from a symbolic factorization and the speed of a small matrix product on this
  /// machine. Throws TooLargeError as factorization_cost() does.
  Estimate condensed(const Body &body) const;

  /// The same from the size alone, for a solid and a usual machine. A half-space has this estimate alone.
  Estimate usual() const;

  /// A lower bound of the same: the stiffness and the dense compliance; and its memory, which measures
  /// nothing, GB.
  Estimate least() const;
  double least_gigabytes() const;

  /// The body with multigrid. It makes coarsest meshes of up to 200 000 cells to find the stretch of their
  /// cells. And its memory, for which no mesh is made, GB.
  Estimate multigrid() const;
  double multigrid_gigabytes() const;

  /// Throws TooLargeError if the stiffness or the compliance have more entries than a factorization can
  /// count, whatever the memory.
  void require_countable() const;

  /// The memory that the model needs, GB, or 0 where this is certainly less than `gigabytes`. It makes the
  /// mesh and finds an order only where the answer depends on them. Throws as require_countable().
  double needed_gigabytes(double gigabytes) const;

private:
  bool is_meshed() const;
  Estimate of_grid() const;
  Estimate of_factorization(const FactorizationCost &factor, double rate) const;
  double dense(double n_matrices) const;
  double step_gigabytes() const;
  double volume_seconds_per_step() const;

  const Parameters &parameters_;
  const ModelSymmetry symmetry_;
  ModelSize size_;
};

/// CostModel::size().
ModelSize model_size(const Parameters &parameters, const ModelSymmetry &symmetry);

/// Whether the model is likely to need more memory than `gigabytes`, or cannot be counted.
bool is_too_large(const Parameters &parameters, const ModelSymmetry &symmetry, double gigabytes);

/// The sentence on a model that needs `needed` GB, if these exceed the limit, or "".
std::string lack_of_memory(double needed, const MemoryLimit &limit);

/// Throws TooLargeError as CostModel::require_countable() does, or InputError if the model is likely to need
/// more memory than the limit.
void require_memory(const Parameters &parameters, const ModelSymmetry &symmetry, const MemoryLimit &limit);
} // namespace orthocone
