// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "v_cycle.h"

#include <vector>

namespace orthocone
{
/// A displacement (mm), and the forces that remain beside its own K u (N).
struct ApproximateSolution
{
  BodyVector<double> displacement, residual;
};

/// Displacements of a body by forces: conjugate gradients with one V-cycle an iteration, from the best
/// combination of earlier solutions (P. F. Fischer, Projection techniques for iterative solution of Ax = b
/// with successive right-hand sides, 1998).
class ElasticSolver
{
public:
  using Vector = BodyVector<double>;

  /// All arguments must outlive the solver.
  ElasticSolver(const MatrixFreeStiffness<double> &stiffness, VCycle &cycle);

  /// The displacement u with ||K u - forces|| <= accuracy ||forces||. Throws SolveError if that is out of
  /// reach.
  Vector solve(const Vector &forces, double accuracy);

  /// The best combination of earlier solutions, for one product with K.
  ApproximateSolution approximate(const Vector &forces) const;

  /// SolutionMemory::forget_trials() and restore().
  const std::vector<Eigen::VectorXd> &forget_trials(const Vector &forces, double accuracy);
  void restore(const std::vector<Eigen::VectorXd> &accepted);

  /// Remembers a displacement and the forces K u that go with it.
  void remember(const Vector &displacement, const Vector &forces);

private:
  struct Known
  {
    Vector displacement, forces;
  };

  Vector best_start(const Vector &forces) const;
  Eigen::VectorXd works_with(const Vector &forces) const;
  Eigen::VectorXd combination(const Eigen::VectorXd &works) const;
  void forget(std::size_t which, Eigen::VectorXd &with_known);

  static constexpr std::size_t most_known = 5; // the last states, and trials after them

  const MatrixFreeStiffness<double> &stiffness_;
  VCycle &cycle_;
  std::vector<Eigen::VectorXd> accepted_; ///< displacements of the last accepted states, mm
  std::vector<Known> known_;              ///< the oldest first
  Eigen::MatrixXd energies_;              ///< displacement times forces of each pair, N mm
};
} // namespace orthocone
