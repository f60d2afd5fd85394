// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The contact solvers, for the factory and for each other.
#pragma once

#include "inner_compliance.h"

#include <orthocone/contact/contact_solver.h>
#include <orthocone/contact/one_node.h>

#include <cmath>
#include <utility>

namespace orthocone
{
/// Gauss-Seidel sweeps: every node in turn is solved exactly with the forces of the others fixed.
class GaussSeidel : public ContactSolver
{
public:
  GaussSeidel(const ContactProblem &problem, const ContactSolverOptions &options);

  SolverReport solve(NodeVector &force) override;

  /// One sweep over all nodes, in place; `relaxation` is the share of the one-node solutions that is taken.
  void sweep(NodeVector &force, double relaxation) const;

private:
  const ContactProblem &problem_;
  ContactSolverOptions options_;
  std::vector<OneNodeProblem> nodes_;
};

/// The paper's Box 3 node by node: one prediction-correction a node and sweep with the literal p and
/// rho = 1 / min(w_nn, w_xx, w_yy). No convergence is guaranteed: see docs/theory.md.
class Feng2006 : public ContactSolver
{
public:
  Feng2006(const ContactProblem &problem, const ContactSolverOptions &options);

  SolverReport solve(NodeVector &force) override;

private:
  void sweep(NodeVector &force) const;

  const ContactProblem &problem_;
  ContactSolverOptions options_;
  std::vector<double> rho_;
};

/// The paper's Box 3 for all nodes at once, as its text reads: prediction and correction with the
/// displacements that the forces of the last iteration cause. Diverges where rho times the largest eigenvalue
/// of W exceeds 2, which is nearly everywhere: for study only.
class Box3 : public ContactSolver
{
public:
  Box3(const ContactProblem &problem, const ContactSolverOptions &options);

  SolverReport solve(NodeVector &force) override;

private:
  const ContactProblem &problem_;
  ContactSolverOptions options_;
};

/// Semismooth Newton on the natural map as textbooks have it, every step taken in full. Cycles where the
/// pieces of the map send it to and fro: for study only.
class PlainNewton : public ContactSolver
{
public:
  PlainNewton(const ContactProblem &problem, const ContactSolverOptions &options);

  SolverReport solve(NodeVector &force) override;

private:
  const ContactProblem &problem_;
  ContactSolverOptions options_;
  InnerCompliance inner_;
};

/// Simultaneous projections with a self-adaptive step: the projection-contraction method of He and Liao (J.
/// Optim. Theory Appl. 112 (2002) 111-128). Needs products with W only.
class Uzawa : public ContactSolver
{
public:
  Uzawa(const ContactProblem &problem, const ContactSolverOptions &options);

  SolverReport solve(NodeVector &force) override;

private:
  NodeVector modified(const NodeVector &force) const;
  NodeVector predicted(const NodeVector &force, const NodeVector &direction, double factor) const;
  void iterate(NodeVector &force, double &factor) const;

  const ContactProblem &problem_;
  ContactSolverOptions options_;
  NodeVector rho_; ///< step of each unknown; the metric of the method is diag(1 / rho)
};

/// Semismooth Newton on the natural map with a backtracking line search, started by exact sweeps and
/// returning to them from the best iterate whenever it stalls, so that it inherits their robustness.
class SemismoothNewton : public ContactSolver
{
public:
  SemismoothNewton(const ContactProblem &problem, const ContactSolverOptions &options);

  SolverReport solve(NodeVector &force) override;

private:
  double iterate_while_it_pays(NodeVector &force, unsigned int &iterations, Trace &trace) const;
  double iterate_in_full(NodeVector trial, double least, NodeVector &force, unsigned int &iterations,
                         Trace &trace) const;

  const ContactProblem &problem_;
  ContactSolverOptions options_;
  GaussSeidel sweeps_;
  InnerCompliance inner_;
};

/// Calls `iterate` until the residual is within the tolerance, the iterations are used up, or the forces are
/// no longer numbers. The residual costs about as much as an iteration and is looked at every `interval` of
/// them.
template<typename Iterate>
SolverReport iterate_until_converged(const ContactProblem &problem, const ContactSolverOptions &options,
                                     const unsigned int interval, NodeVector &force, const Iterate &iterate)
{
  unsigned int n_iterations = 0;
  Trace trace;
  double residual = problem.residual(force);
  while (residual > options.tolerance && n_iterations < options.maximum_iterations && std::isfinite(residual))
  {
    trace.add(n_iterations, residual, problem.force_scale(force));
    for (unsigned int i = 0; i < interval && n_iterations < options.maximum_iterations; ++i, ++n_iterations)
      iterate(force);
    residual = problem.residual(force);
  }
  return make_report(problem, force, n_iterations, options.tolerance, std::move(trace));
}

/// Step of the paper's Box 3 at a node: factor / min(w_nn, w_xx, w_yy).
inline double rho_of_box3(const ContactProblem &problem, const Eigen::Index node, const double factor)
{
  return factor / problem.compliance().diagonal_block(node).diagonal().minCoeff();
}

/// The dense compliance, or std::invalid_argument naming the method that wants it.
const Eigen::MatrixXd &dense_compliance(const ContactProblem &problem, const char *method);
} // namespace orthocone
