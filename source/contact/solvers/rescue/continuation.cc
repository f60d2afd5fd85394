// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "continuation.h"

#include "ladder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// A law between the associated one (t = 0) and the given one (t = 1): the logarithms of the semi-axes of the
/// slip ellipse are linear in t.
OrthotropicFriction between_slip_rules(OrthotropicFriction law, const double t)
{
  if (is_frictionless(law))
    return law;
  const double ratio = std::pow(law.p_x / law.p_y, t) * std::pow(law.mu_x / law.mu_y, 1 - t);
  law.p_x = law.mu_x;
  law.p_y = law.p_x / ratio;
  return law;
}

ContactSystem between_slip_rules(const ContactSystem &system, const double t)
{
  std::vector<OrthotropicFriction> laws;
  for (Eigen::Index node = 0; node < system.n_nodes(); ++node)
    laws.push_back(between_slip_rules(system.given_law(node), t));
  return {system.compliance(), std::move(laws)};
}
} // namespace

bool is_associated(const ContactSystem &system)
{
  constexpr double rounding = 1e-12;
  for (Eigen::Index node = 0; node < system.n_nodes(); ++node)
  {
    const OrthotropicFriction &law = system.given_law(node);
    if (!is_frictionless(law) && std::abs(law.p_x * law.mu_y / (law.p_y * law.mu_x) - 1) > rounding)
      return false;
  }
  return true;
}

SolverReport Continuation::solve_at(const ContactStep &step, const double t, Path &path) const
{
  // Where slip is far from associated, a residual of 1e-5 does not mean that the solution is near. Short
  // steps take few iterations.
  constexpr double accurate = 1e-9;
  constexpr unsigned int most_iterations = 20; // docs/performance.md, "Multigrid"
  Allowances allowances = without_groups({});
  allowances.leaps = 0; // they would leave the path
  ContactSolverOptions options = options_;
  options.maximum_iterations = std::min(options.maximum_iterations, most_iterations);
  VectorXd unknowns = path.unknowns;
  const auto solve = [&](const ContactStep &problem)
  {
    return make_whole_body_newton(problem.system(), options, allowances, Continue::never)
        ->solve(problem, unknowns);
  };
  SolverReport report;
  if (t < 1)
  {
    options.tolerance = accurate;
    const ContactSystem system = between_slip_rules(step.system(), t);
    report = solve(ContactStep(system, step.q(), step.face()));
  }
  else
    report = solve(step);
  path.iterations += report.iterations;
  if (report.converged)
    path.unknowns = std::move(unknowns);
  return report;
}

std::optional<SolverReport> Continuation::follow(const ContactStep &step, Path &path) const
{
  constexpr double first = 0.25, least = 1. / 256; // of the path: docs/performance.md, "Multigrid"
  if (!solve_at(step, 0, path).converged)
    return std::nullopt;
  for (double t = 0, length = first; length >= least;)
  {
    const double next = std::min(1., t + length);
    SolverReport report = solve_at(step, next, path);
    if (report.converged && next == 1)
      return report;
    t = report.converged ? next : t;
    length *= report.converged ? 1.2 : 0.5;
  }
  return std::nullopt;
}
} // namespace orthocone
