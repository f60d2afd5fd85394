// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/law/one_node.h>
#include <orthocone/contact/solvers/contact_solver.h>

#include <vector>

namespace orthocone
{
/// Nonlinear Gauss-Seidel (Jourdan, Alart and Jean, Comput. Methods Appl. Mech. Engrg. 155 (1998) 31): every
/// node i in turn is solved exactly, d_i = (q_i + sum over j != i of W_ij r_j) + W_ii r_i with the forces r_j
/// of the others fixed. It needs no slope, so that it gets on where Newton's method stalls, but slowly:
/// forces travel over a large surface in many sweeps.
class GaussSeidel : public ContactSolver
{
public:
  GaussSeidel(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

  /// One sweep over all nodes, in place; `relaxation` is the share of the one-node solutions that is taken.
  void sweep(const ContactStep &step, Eigen::VectorXd &unknowns, double relaxation) const;

private:
  void sweep_with_face(const ContactStep &step, Eigen::VectorXd &unknowns, double relaxation) const;

  const ContactSystem &system_;
  ContactSolverOptions options_;
  std::vector<OneNodeProblem> nodes_;
};
} // namespace orthocone
