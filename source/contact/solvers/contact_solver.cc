// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "face/balancing_face.h"
#include "face/load_limit.h"
#include "rescue/worst_nodes.h"
#include "solvers.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace orthocone
{
namespace
{
/// Whether forces have grown until rounding hides what penetrates. Then the residual, which is relative to
/// them, says nothing. This happens where no forces close the gaps, because W is singular.
bool is_blind(const LawErrors &law, const double tolerance)
{
  constexpr double visible = 0.1;             // of the largest displacement
  constexpr double of_loose_tolerances = 100; // a residual may cause this many times as much penetration
  return law.penetration > std::max(visible, of_loose_tolerances * tolerance);
}

/// How an iteration has ended: this is the one place that decides it. The trace says whether the residual
/// still fell (judge()). That there is no equilibrium is said in three cases: the method has watched the face
/// run away; it cycles while nothing holds the face; or a motion of the face proves it. Forces that hide what
/// penetrates have diverged, however small their relative residual is.
Verdict verdict_of(const SolverReport &report, const ContactStep &step, const Eigen::VectorXd &unknowns,
                   const double tolerance, const Balance balance)
{
  if (balance == Balance::lost)
    return Verdict::unbalanced;
  const Verdict of_trace = judge(report.trace.points(), tolerance, step.system().rounding());
  if (report.converged)
    return of_trace;
  if ((of_trace == Verdict::cycling && nothing_holds(step, unknowns)) || is_beyond_every_force(step))
    return balance == Balance::unknown ? Verdict::cycling : Verdict::unbalanced;
  return of_trace == Verdict::converged ? Verdict::diverged : of_trace;
}
} // namespace

SolverReport make_report(const ContactStep &step, const Eigen::VectorXd &unknowns,
                         const unsigned int iterations, const double tolerance, Trace trace)
{
  return make_report(step, unknowns, iterations, tolerance, std::move(trace), Balance::judged);
}

SolverReport make_report(const ContactStep &step, const Eigen::VectorXd &unknowns,
                         const unsigned int iterations, const double tolerance, Trace trace,
                         const Balance balance)
{
  const NodeVector d = step.displacement(unknowns);
  const Eigen::VectorXd map = step.natural_map(unknowns, d);
  SolverReport report;
  report.iterations = iterations;
  report.residual = step.residual_of(map, unknowns);
  report.law = law_errors(step, unknowns, d);
  report.converged = report.residual <= tolerance && !is_blind(report.law, tolerance);
  report.worst_node = worst_node(map, step.n_nodes());
  for (Eigen::Index node = 0; node < step.n_nodes(); ++node)
    report.penetration = std::max(report.penetration, -d[3 * node]);
  trace.add(iterations, report.residual, step.force_scale(unknowns));
  report.trace = std::move(trace);
  report.verdict = verdict_of(report, step, unknowns, tolerance, balance);
  return report;
}

SolverReport solve_or_rescue(const ContactSolver &solver, const ContactStep &step, Eigen::VectorXd &unknowns)
{
  SolverReport report = solver.solve(step, unknowns);
  if (report.converged || report.verdict == Verdict::unbalanced)
    return report;
  auto rescued = solver.rescue(step, unknowns);
  if (!rescued)
    return report;
  rescued->iterations += report.iterations;
  return *std::move(rescued);
}

const DenseView &dense_compliance(const ContactSystem &system, const char *const method)
{
  const DenseView *const matrix = system.compliance().dense();
  if (matrix == nullptr)
    throw std::invalid_argument(std::string("Contact solver/Method = ") + method +
                                " needs the dense compliance, which this backend does not have");
  return *matrix;
}

const OrthotropicFriction &ellipse_of(const ContactStep &step, const Eigen::Index node,
                                      const char *const method)
{
  const OrthotropicFriction *const ellipse = step.law(node).ellipse();
  if (ellipse == nullptr)
    throw std::invalid_argument(std::string("Contact solver/Method = ") + method +
                                " needs friction ellipses, and the law of node " + std::to_string(node) +
                                " is none");
  return *ellipse;
}

std::unique_ptr<ConditionSolver> condition_solver(const ContactSystem &system, const char *const method)
{
  auto solver = system.compliance().condition_solver(system.softness());
  if (solver == nullptr)
    throw std::invalid_argument(std::string("Contact solver/Method = ") + method +
                                " needs a solver of linearized laws, which this backend does not have");
  return solver;
}
} // namespace orthocone
