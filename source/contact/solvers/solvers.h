// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The contact solvers, for the factory and for each other.
#pragma once

#include "balancing_face.h"

#include <orthocone/contact/law/one_node.h>
#include <orthocone/contact/solvers/contact_solver.h>

#include <cmath>
#include <utility>

namespace orthocone
{
/// Gauss-Seidel sweeps: every node in turn is solved exactly with the forces of the others fixed.
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

/// The paper's Box 3 node by node: one prediction-correction a node and sweep with the literal p and
/// rho = 1 / min(w_nn, w_xx, w_yy). No convergence is guaranteed: see docs/theory.md.
class Feng2006 : public ContactSolver
{
public:
  Feng2006(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  void sweep(const ContactStep &step, Eigen::VectorXd &unknowns) const;

  const ContactSystem &system_;
  ContactSolverOptions options_;
  std::vector<double> rho_;
};

/// The paper's Box 3 for all nodes at once, as its text reads: prediction and correction with the
/// displacements that the forces of the last iteration cause. Diverges where rho times the largest eigenvalue
/// of W exceeds 2, which is nearly everywhere: for study only.
class Box3 : public ContactSolver
{
public:
  Box3(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  const ContactSystem &system_;
  ContactSolverOptions options_;
};

/// Semismooth Newton on the natural map as textbooks have it, every step taken in full. Cycles where the
/// pieces of the map send it to and fro: for study only.
class PlainNewton : public ContactSolver
{
public:
  PlainNewton(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  ContactSolverOptions options_;
  std::unique_ptr<ConditionSolver> conditions_;
};

/// Simultaneous projections with a self-adaptive step: the projection-contraction method of He and Liao (J.
/// Optim. Theory Appl. 112 (2002) 111-128). Needs products with W only.
class Uzawa : public ContactSolver
{
public:
  Uzawa(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  const ContactSystem &system_;
  ContactSolverOptions options_;
};

/// Semismooth Newton on the natural map with a backtracking line search, started by exact sweeps and
/// returning to them from the best iterate whenever it stalls, so that it inherits their robustness.
class SemismoothNewton : public ContactSolver
{
public:
  SemismoothNewton(const ContactSystem &system, const ContactSolverOptions &options);

  SolverReport solve(const ContactStep &step, Eigen::VectorXd &unknowns) const override;

private:
  /// A step on the way to its solution.
  struct Progress;

  void iterate_while_it_pays(Progress &progress) const;
  void iterate_in_full(Eigen::VectorXd trial, Progress &progress) const;
  bool run_round(unsigned int round, unsigned int n_sweeps, Progress &progress) const;

  ContactSolverOptions options_;
  GaussSeidel sweeps_;
  std::unique_ptr<ConditionSolver> conditions_;
};

/// make_report() of a step without equilibrium.
SolverReport unbalanced_report(const ContactStep &step, const Eigen::VectorXd &unknowns,
                               unsigned int iterations, double tolerance, Trace trace);

/// Calls `iterate` until the residual is within the tolerance, the iterations are used up, the unknowns are
/// no longer numbers or the face runs away. The residual costs about as much as an iteration and is looked at
/// every `interval` of them.
template<typename Iterate>
SolverReport iterate_until_converged(const ContactStep &step, const ContactSolverOptions &options,
                                     const unsigned int interval, Eigen::VectorXd &unknowns,
                                     const Iterate &iterate)
{
  unsigned int n_iterations = 0;
  Trace trace;
  BalanceWatch balance;
  double residual = step.residual(unknowns);
  while (residual > options.tolerance && n_iterations < options.maximum_iterations && std::isfinite(residual))
  {
    trace.add(n_iterations, residual, step.force_scale(unknowns));
    for (unsigned int i = 0; i < interval && n_iterations < options.maximum_iterations; ++i, ++n_iterations)
      iterate(unknowns);
    residual = step.residual(unknowns);
    if (residual > options.tolerance && balance.runs_away(step, unknowns))
      return unbalanced_report(step, unknowns, n_iterations, options.tolerance, std::move(trace));
  }
  return make_report(step, unknowns, n_iterations, options.tolerance, std::move(trace));
}

/// Step of the paper's Box 3 at a node: factor / min(w_nn, w_xx, w_yy).
inline double rho_of_box3(const ContactSystem &system, const Eigen::Index node, const double factor)
{
  return factor / system.compliance().diagonal_block(node).diagonal().minCoeff();
}

/// The dense compliance, or std::invalid_argument naming the method that wants it.
const Eigen::MatrixXd &dense_compliance(const ContactSystem &system, const char *method);

/// The backend's solver of linearized laws, or std::invalid_argument naming the method that wants it.
std::unique_ptr<ConditionSolver> condition_solver(const ContactSystem &system, const char *method);
} // namespace orthocone
