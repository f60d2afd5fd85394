// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solvers.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace orthocone
{
SolverReport make_report(const ContactProblem &problem, const NodeVector &force,
                         const unsigned int iterations, const double tolerance, Trace trace)
{
  const NodeVector d = problem.displacement(force);
  const NodeVector map = problem.natural_map(force, d);
  SolverReport report;
  report.iterations = iterations;
  report.residual = problem.residual_of(map, force);
  report.converged = report.residual <= tolerance;
  report.law = law_errors(problem, force, d);
  trace.add(iterations, report.residual, problem.force_scale(force));
  report.verdict = judge(trace.points(), tolerance, problem.rounding());
  report.trace = std::move(trace);
  double worst = -1;
  for (Eigen::Index node = 0; node < problem.n_nodes(); ++node)
  {
    const double error = map.segment<3>(3 * node).norm();
    if (error > worst || std::isnan(error))
    {
      worst = error;
      report.worst_node = node;
    }
    report.penetration = std::max(report.penetration, -d[3 * node]);
  }
  return report;
}

const Eigen::MatrixXd &dense_compliance(const ContactProblem &problem, const char *const method)
{
  const Eigen::MatrixXd *const matrix = problem.compliance().dense();
  if (matrix == nullptr)
    throw std::invalid_argument(std::string("Contact solver/Method = ") + method +
                                " needs the dense compliance, which this backend does not have");
  return *matrix;
}

std::unique_ptr<ContactSolver> make_contact_solver(const ContactProblem &problem,
                                                   const ContactSolverOptions &options)
{
  switch (options.method)
  {
  case ContactMethod::newton:
    return std::make_unique<SemismoothNewton>(problem, options);
  case ContactMethod::gauss_seidel:
    return std::make_unique<GaussSeidel>(problem, options);
  case ContactMethod::uzawa:
    return std::make_unique<Uzawa>(problem, options);
  case ContactMethod::feng2006:
    return std::make_unique<Feng2006>(problem, options);
  case ContactMethod::box3:
    return std::make_unique<Box3>(problem, options);
  case ContactMethod::plain_newton:
    return std::make_unique<PlainNewton>(problem, options);
  }
  throw std::invalid_argument("unknown contact method");
}
} // namespace orthocone
