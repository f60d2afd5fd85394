// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>

#include <optional>

namespace orthocone
{
/// Whether there is a node whose law has an easier one to come from.
bool has_easier_laws(const ContactStep &step);

/// Continuation in the friction laws, from easier ones (t = 0; of ellipses the associated one, whose natural
/// map depends on the cone alone) to the given ones (t = 1): each solution is the start of the next (natural
/// parameter continuation: Allgower and Georg, Numerical Continuation Methods, 1990). It is for bodies
/// without a dense W, where no sweeps can help.
class Continuation
{
public:
  explicit Continuation(const ContactSolverOptions &options)
      : options_(options)
  {
  }

  /// The unknowns along the path, and the work so far.
  struct Path
  {
    Eigen::VectorXd unknowns;
    unsigned int iterations = 0;
  };

  /// Follows the path in steps that are as long as they may be. Returns nothing where even short ones fail.
  std::optional<SolverReport> follow(const ContactStep &step, Path &path) const;

private:
  SolverReport solve_at(const ContactStep &step, double t, Path &path) const;

  ContactSolverOptions options_;
};
} // namespace orthocone
