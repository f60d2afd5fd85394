// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "continuation.h"

#include "ladder.h"

#include <orthocone/contact/law/law_path.h>

#include <algorithm>
#include <utility>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// The step with laws a share t of the path. Nodes that have one law follow one another as a rule.
ContactStep between_laws(const ContactStep &step, const double t)
{
  FrictionLaws laws;
  for (std::size_t i = 0; i < step.laws().size(); ++i)
    laws.push_back(i > 0 && step.laws()[i].is_same(step.laws()[i - 1]) ? laws.back()
                                                                       : law_on_path(step.laws()[i], t));
  return step.with_laws(std::move(laws));
}
} // namespace

bool has_easier_laws(const ContactStep &step)
{
  return std::any_of(step.laws().begin(), step.laws().end(), has_easier_law);
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
  if (t < 1)
    options.tolerance = accurate;
  SolverReport report = make_whole_body_newton(step.system(), options, allowances, Continue::never)
                            ->solve(t < 1 ? between_laws(step, t) : step, unknowns);
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
