// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "../solvers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// A law on the way from the associated one (t = 0), whose natural map depends on the cone alone, to the
/// given one (t = 1): the logarithms of the semi-axes of the slip ellipse are linear in t.
OrthotropicFriction on_the_way(OrthotropicFriction law, const double t)
{
  if (is_frictionless(law))
    return law;
  const double ratio = std::pow(law.p_x / law.p_y, t) * std::pow(law.mu_x / law.mu_y, 1 - t);
  law.p_x = law.mu_x;
  law.p_y = law.p_x / ratio;
  return law;
}

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

ContactSystem system_on_the_way(const ContactSystem &system, const double t)
{
  std::vector<OrthotropicFriction> laws;
  for (Eigen::Index node = 0; node < system.n_nodes(); ++node)
    laws.push_back(on_the_way(system.given_law(node), t));
  return {system.compliance(), std::move(laws)};
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

/// Newton's method on the map that stalls less often, and on the other one where it stalls.
class OnEitherMap : public ContactSolver
{
public:
  OnEitherMap(const ContactSystem &system, const ContactSolverOptions &options,
              const Allowances &allowances = {})
      : alart_curnier_(make_inexact_newton(system, options, allowances)),
        natural_(make_natural_newton(system, options, without_groups(allowances)))
  {
  }

  SolverReport solve(const ContactStep &step, VectorXd &unknowns) const override
  {
    const VectorXd start = unknowns;
    SolverReport report = alart_curnier_->solve(step, unknowns);
    if (report.converged || !may_be_solvable(report.verdict))
      return report;
    const unsigned int iterations = report.iterations;
    unknowns = start;
    report = natural_->solve(step, unknowns);
    report.iterations += iterations;
    return report;
  }

private:
  std::unique_ptr<ContactSolver> alart_curnier_, natural_;
};

/// Newton's method. Where it does not converge for a slip rule far from the associated one, it solves with
/// slip rules between both, each from the solution of the one before: without a dense W no sweeps can help.
class Continuation : public ContactSolver
{
public:
  Continuation(const ContactSystem &system, const ContactSolverOptions &options)
      : options_(options),
        newton_(system, options),
        is_associated_(is_associated(system))
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
  OnEitherMap newton_;
  bool is_associated_;
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
  SolverReport report;
  if (t < 1)
  {
    options.tolerance = accurate;
    const ContactSystem system = system_on_the_way(step.system(), t);
    report =
        OnEitherMap(system, options, allowances).solve(ContactStep(system, step.q(), step.face()), unknowns);
  }
  else
    report = OnEitherMap(step.system(), options, allowances).solve(step, unknowns);
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
  SolverReport report = newton_.solve(step, unknowns);
  if (report.converged || is_associated_ || !may_be_solvable(report.verdict))
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
