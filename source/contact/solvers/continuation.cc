// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "solvers.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// Whether slip is associated at all nodes, so that there is no other law to start from.
bool is_associated(const ContactStep &step)
{
  return std::all_of(step.laws().begin(), step.laws().end(),
                     [](const FrictionLaw &law) { return is_associated(law); });
}

/// The step with a share of the way from the associated slip rule, whose natural map depends on the cone
/// alone, to the given one.
ContactStep on_the_way(const ContactStep &step, const double t)
{
  FrictionLaws laws;
  for (const FrictionLaw &law : step.laws())
    laws.push_back(towards_associated(law, t));
  return step.with_laws(std::move(laws));
}

/// Whether another way may find what Newton's method did not.
bool may_be_solvable(const Verdict verdict)
{
  return verdict == Verdict::cycling || verdict == Verdict::slow || verdict == Verdict::diverged;
}

/// Nodes in groups cost many solutions: they are for the first method alone.
Allowances without_groups(Allowances allowances)
{
  allowances.nodes_in_groups = 0;
  return allowances;
}

/// Newton's method. Where it does not converge for a slip rule far from the associated one, it solves with
/// slip rules between both, each from the solution of the one before: without a dense W no sweeps can help.
class Continuation : public ContactSolver
{
public:
  Continuation(const ContactSystem &system, const ContactSolverOptions &options)
      : options_(options),
        newton_(make_inexact_newton(system, options))
  {
  }

  SolverReport solve(const ContactStep &step, VectorXd &unknowns) const override;

private:
  /// The unknowns on the way, and the work so far.
  struct Walk
  {
    VectorXd unknowns;
    unsigned int iterations = 0;
  };

  std::optional<SolverReport> follow(const ContactStep &step, Walk &walk) const;
  SolverReport solve_at(const ContactStep &step, double t, Walk &walk) const;

  ContactSolverOptions options_;
  std::unique_ptr<ContactSolver> newton_;
};

SolverReport Continuation::solve_at(const ContactStep &step, const double t, Walk &walk) const
{
  // Where slip is far from associated, a residual of 1e-5 does not mean that the solution is near. Short ways
  // take few iterations.
  constexpr double accurate = 1e-9;
  constexpr unsigned int most_iterations = 20; // docs/performance.md, "Multigrid"
  Allowances allowances = without_groups({});
  allowances.leaps = 0; // they would leave the way
  ContactSolverOptions options = options_;
  options.maximum_iterations = std::min(options.maximum_iterations, most_iterations);
  VectorXd unknowns = walk.unknowns;
  if (t < 1)
    options.tolerance = accurate;
  const auto newton = make_inexact_newton(step.system(), options, allowances);
  const SolverReport report = newton->solve(t < 1 ? on_the_way(step, t) : step, unknowns);
  walk.iterations += report.iterations;
  if (report.converged)
    walk.unknowns = std::move(unknowns);
  return report;
}

/// Follows the way in steps that are as long as they may be; returns nothing where even short ones fail.
std::optional<SolverReport> Continuation::follow(const ContactStep &step, Walk &walk) const
{
  constexpr double first = 0.25, least = 1. / 256; // of the way: docs/performance.md, "Multigrid"
  if (!solve_at(step, 0, walk).converged)
    return std::nullopt;
  for (double t = 0, length = first; length >= least;)
  {
    const double next = std::min(1., t + length);
    SolverReport report = solve_at(step, next, walk);
    if (report.converged && next == 1)
      return report;
    t = report.converged ? next : t;
    length *= report.converged ? 1.2 : 0.5;
  }
  return std::nullopt;
}

SolverReport Continuation::solve(const ContactStep &step, VectorXd &unknowns) const
{
  Walk walk{unknowns};
  SolverReport report = newton_->solve(step, unknowns);
  if (report.converged || is_associated(step) || !may_be_solvable(report.verdict))
    return report;
  const unsigned int iterations = report.iterations;
  if (auto followed = follow(step, walk))
  {
    report = std::move(*followed);
    unknowns = std::move(walk.unknowns);
  }
  report.iterations = iterations + walk.iterations;
  return report;
}
} // namespace

std::unique_ptr<ContactSolver> make_continuation(const ContactSystem &system,
                                                 const ContactSolverOptions &options)
{
  return make<Continuation>(system, options);
}
} // namespace orthocone
