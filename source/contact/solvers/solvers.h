// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Code that the contact solvers share, and their list for contact_methods.cc.
#pragma once

#include "face/balancing_face.h"

#include <orthocone/contact/solvers/contact_method.h>
#include <orthocone/contact/solvers/contact_solver.h>

#include <cmath>
#include <utility>

namespace orthocone
{
/// What a method may say of the balance of a face that forces drive.
enum class Balance
{
  judged,  ///< by its final unknowns
  lost,    ///< the face has run away
  unknown, ///< nothing: the method fails where there is equilibrium, too, and its faces run away then
};

/// make_report() of a method that knows more than its unknowns say.
SolverReport make_report(const ContactStep &step, const Eigen::VectorXd &unknowns, unsigned int iterations,
                         double tolerance, Trace trace, Balance balance);

/// Calls `iterate` until the residual is within the tolerance, the iterations are used up, the unknowns are
/// no longer numbers or the face runs away. The residual costs about as much as an iteration and is evaluated
/// after every `interval` of them.
template<typename Iterate>
SolverReport iterate_until_converged(const ContactStep &step, const ContactSolverOptions &options,
                                     const unsigned int interval, Eigen::VectorXd &unknowns,
                                     const Iterate &iterate, Balance balance = Balance::judged)
{
  unsigned int n_iterations = 0;
  Trace trace;
  BalanceWatch watch;
  double residual = step.residual(unknowns);
  while (residual > options.tolerance && n_iterations < options.maximum_iterations &&
         std::isfinite(residual) && balance != Balance::lost)
  {
    trace.add(n_iterations, residual, step.force_scale(unknowns));
    for (unsigned int i = 0; i < interval && n_iterations < options.maximum_iterations; ++i, ++n_iterations)
      iterate(unknowns);
    residual = step.residual(unknowns);
    if (balance == Balance::judged && residual > options.tolerance && watch.runs_away(step, unknowns))
      balance = Balance::lost;
  }
  return make_report(step, unknowns, n_iterations, options.tolerance, std::move(trace), balance);
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

// The file of each solver defines its method.
ContactMethod newton_method();
ContactMethod gauss_seidel_method();
ContactMethod uzawa_method();
ContactMethod feng2006_method();
ContactMethod box3_method();
ContactMethod plain_newton_method();
} // namespace orthocone
