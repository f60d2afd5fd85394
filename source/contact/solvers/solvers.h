// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Code that the contact solvers share, and their list for contact_methods.cc.
#pragma once

#include "balancing_face.h"

#include <orthocone/contact/law/one_node.h>
#include <orthocone/contact/solvers/contact_method.h>
#include <orthocone/contact/solvers/contact_solver.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace orthocone
{
/// Gauss-Seidel sweeps: every node in turn is solved exactly, with the forces of the others fixed.
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

/// Iterations of Newton's method without a dense compliance: more have never helped, and each is expensive.
constexpr unsigned int most_inexact_iterations = 60;

/// make_report() of a step without equilibrium.
SolverReport unbalanced_report(const ContactStep &step, const Eigen::VectorXd &unknowns,
                               unsigned int iterations, double tolerance, Trace trace);

/// Whether a method that does not get on may say that there is no equilibrium. Methods that fail where there
/// is one may not: their faces run away for other reasons, too.
enum class Diagnosis
{
  of_balance,
  none
};

/// Calls `iterate` until the residual is within the tolerance, the iterations are used up, the unknowns are
/// no longer numbers or the face runs away. The residual costs about as much as an iteration and is evaluated
/// after every `interval` of them.
template<typename Iterate>
SolverReport iterate_until_converged(const ContactStep &step, const ContactSolverOptions &options,
                                     const unsigned int interval, Eigen::VectorXd &unknowns,
                                     const Iterate &iterate,
                                     const Diagnosis diagnosis = Diagnosis::of_balance)
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
    if (diagnosis == Diagnosis::of_balance && residual > options.tolerance &&
        balance.runs_away(step, unknowns))
      return unbalanced_report(step, unknowns, n_iterations, options.tolerance, std::move(trace));
  }
  SolverReport report = make_report(step, unknowns, n_iterations, options.tolerance, std::move(trace));
  if (diagnosis == Diagnosis::none && report.verdict == Verdict::unbalanced)
    report.verdict = Verdict::cycling;
  return report;
}

/// Step of the paper's Box 3 at a node: factor / min(w_nn, w_xx, w_yy), N/mm.
inline double rho_of_box3(const ContactSystem &system, const Eigen::Index node, const double factor)
{
  return factor / system.compliance().diagonal_block(node).diagonal().minCoeff();
}

/// The dense compliance. Throws std::invalid_argument, which names the method, where there is none.
const DenseView &dense_compliance(const ContactSystem &system, const char *method);

/// The backend's solver of linearized laws. Throws std::invalid_argument, which names the method, where there
/// is none.
std::unique_ptr<ConditionSolver> condition_solver(const ContactSystem &system, const char *method);

/// The two ellipses of a node, for methods that iterate on the elliptic cone. Throws std::invalid_argument,
/// which names the method, where the law is another one.
const OrthotropicFriction &ellipse_of(const ContactStep &step, Eigen::Index node, const char *method);

/// ContactMethod::make of a solver that is constructed from a system and options.
template<typename Solver>
std::unique_ptr<ContactSolver> make(const ContactSystem &system, const ContactSolverOptions &options)
{
  return std::make_unique<Solver>(system, options);
}

/// How often the steps of one solution may do what leads out of a trap, or only costs.
struct Allowances
{
  unsigned int leaps = 3;           ///< full steps to a larger error; they may lead to another solution
  unsigned int exact_nodes = 3;     ///< nodes that are solved exactly, one at a time
  std::size_t nodes_in_groups = 24; ///< the same, several at a time
};

/// The first one is Newton's method where the backend has no dense compliance. The other one is the method
/// `newton` there: where the first one fails, it follows the solution from the associated slip rule.
std::unique_ptr<ContactSolver> make_inexact_newton(const ContactSystem &system,
                                                   const ContactSolverOptions &options,
                                                   const Allowances &allowances = {});
std::unique_ptr<ContactSolver> make_continuation(const ContactSystem &system,
                                                 const ContactSolverOptions &options);

// The file of each solver defines its method.
ContactMethod newton_method();
ContactMethod gauss_seidel_method();
ContactMethod uzawa_method();
ContactMethod feng2006_method();
ContactMethod box3_method();
ContactMethod plain_newton_method();
} // namespace orthocone
