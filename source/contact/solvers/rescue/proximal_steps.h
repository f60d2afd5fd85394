// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>

#include <optional>

namespace orthocone
{
/// Proximal point iteration for singular compliances, as rigid bodies with more contacts than degrees of
/// freedom have them: forces r that W does not feel are held by a small spring of compliance alpha, and
/// r_new solves the problem with W + alpha I and q - alpha r. At its fixed points the spring is without force
/// (Rockafellar 1976; for this W the map is not monotone, so that nothing is promised). alpha grows where a
/// problem is hard, and shrinks where it is easy.
class ProximalSteps
{
public:
  using Make = std::unique_ptr<ContactSolver>(const ContactSystem &, const ContactSolverOptions &);

  /// `make` makes the solver of the problems with the spring.
  ProximalSteps(const ContactSystem &system, const ContactSolverOptions &options, Make *make);

  /// Whether W is dense and singular to rounding, which takes a factorization. More than 500 nodes are not
  /// looked at.
  bool are_needed() const;
  /// The same for the first few nodes alone, which takes next to no time. Contacts of one rigid body show
  /// there that W is singular.
  bool are_needed_by_few_nodes() const;

  /// Improves `unknowns` and returns the number of iterations of all problems, which is about
  /// `most_iterations` at most.
  unsigned int improve(const ContactStep &step, Eigen::VectorXd &unknowns,
                       unsigned int most_iterations) const;

private:
  const ContactSystem &system_;
  mutable std::optional<bool> are_needed_{}; ///< once it is known
  ContactSolverOptions options_;
  Make *make_;
};
} // namespace orthocone
