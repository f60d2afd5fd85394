// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>

#include <optional>

namespace orthocone
{
/// Solves a step for the few nodes on which its natural map is largest, and for their neighbours. The forces
/// of all other nodes stay as they are. A node that is about to stick or to slip the other way may keep
/// Newton's steps of a whole surface short; a small problem finds its state at little cost (nonlinear
/// elimination: Lanzkron, Rose and Wilkes 1996).
class NonlinearElimination
{
public:
  using Make = std::unique_ptr<ContactSolver>(const ContactSystem &, const ContactSolverOptions &);

  /// Unknowns of the whole step, if the small problem is solved, and the iterations that it took. These count
  /// by its share of the nodes.
  struct Result
  {
    std::optional<Eigen::VectorXd> unknowns{};
    unsigned int iterations = 0;
  };

  /// `make` makes the solver of the small problems; its options are those of the whole step.
  NonlinearElimination(const ContactSolverOptions &options, Make *make);

  /// There is no small problem where the map is not concentrated on few nodes, on a small surface, and where
  /// W is not dense. `displacement` (mm) belongs to `unknowns`.
  Result solve(const ContactStep &step, const Eigen::VectorXd &unknowns,
               const NodeVector &displacement) const;

private:
  ContactSolverOptions options_;
  Make *make_;
};
} // namespace orthocone
