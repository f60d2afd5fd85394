// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "inexact_newton.h"

#include "../face/unheld_face.h"
#include "../rescue/exact_nodes.h"
#include "../rescue/worst_nodes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// Semismooth Newton for a body without a dense compliance: linearized laws are solved on the whole body, and
/// only as accurately as it pays (inexact Newton: Dembo, Eisenstat and Steihaug, SIAM J. Numer. Anal. 19
/// (1982) 400). An iterate is forces and a displacement of the body, which need not be in equilibrium: its
/// error is that of the law and of equilibrium together. There are no sweeps. docs/theory.md, section 3, "A
/// body without a matrix".
class InexactNewton : public ContactSolver
{
public:
  InexactNewton(const ContactSystem &system, const ContactSolverOptions &options,
                const Allowances &allowances, Map *const map)
      : options_(options),
        allowances_(allowances),
        conditions_(condition_solver(system, "newton")),
        newton_(map, *conditions_, options.rho_factor)
  {
  }

  SolverReport solve(const ContactStep &step, VectorXd &unknowns) const override;

private:
  Iterate touching(const ContactStep &step, Iterate iterate) const;
  Iterate next(const ContactStep &step, const Iterate &last, const StepRule &rule,
               Allowances &allowances) const;
  double judge_forces(const ContactStep &step, Iterate &iterate, VectorXd &unknowns) const;

  ContactSolverOptions options_;
  Allowances allowances_;
  std::unique_ptr<ConditionSolver> conditions_;
  NewtonSteps newton_;
};

/// The iterate, with an unheld face moved until nodes hold it. Those that hold it first may let it tilt.
Iterate InexactNewton::touching(const ContactStep &step, Iterate iterate) const
{
  for (Eigen::Index i = 0; i < step.face().n(); ++i)
  {
    const VectorXd increment = increment_of_unheld_face(
        step, iterate.unknowns, iterate.displacement, iterate.linearization.conditions, options_.rho_factor);
    if (increment.size() == 0)
      break;
    const ContactChange moved{NodeVector::Zero(iterate.displacement.size()), increment,
                              step.face().columns() * increment};
    iterate = newton_.behind(step, iterate, moved, 1);
  }
  return iterate;
}

/// The nodes that are to be solved exactly: the hardest one behind a full step, if there is one, a few times.
/// Where that has not helped, those few that are hardest behind or before the step. They may be in a row in
/// which each one slips when its neighbour does. None where the error is on many nodes.
std::vector<Eigen::Index> nodes_to_solve(const ContactStep &step, const Iterate &last, const Iterate &full,
                                         const StepRule &rule, Allowances &allowances)
{
  constexpr std::size_t few = 4;
  const auto node = dominant_node(step, full.unknowns, full.displacement);
  if (node && allowances.exact_nodes > 0)
  {
    --allowances.exact_nodes;
    return {*node};
  }
  std::vector<Eigen::Index> nodes = worst_nodes(step, full.unknowns, full.displacement, few + 1);
  if (nodes.size() > few || !rule.may_solve_nodes)
    return {};
  const auto before = worst_nodes(step, last.unknowns, last.displacement, few + 1);
  if (before.size() <= few)
    for (const Eigen::Index other : before)
      if (std::find(nodes.begin(), nodes.end(), other) == nodes.end())
        nodes.push_back(other);
  if (nodes.size() > allowances.nodes_in_groups)
    return {};
  allowances.nodes_in_groups -= nodes.size();
  return nodes;
}

/// The iterate behind Newton's change. Where that stalls because nodes change their status to and fro, these
/// are solved exactly. For others that is worse at first as a rule. Newton's next steps mend it.
Iterate InexactNewton::next(const ContactStep &step, const Iterate &last, const StepRule &rule,
                            Allowances &allowances) const
{
  constexpr double bearable_growth = 100;
  const ContactConditions &conditions = last.linearization.conditions;
  const ContactChange change = newton_.change(step, last, rule.accuracy);
  const LineSearch search{rule.bound, 1. / 64, LineSearch::Fallback::least_error,
                          rule.may_leap ? &allowances.leaps : nullptr};
  Iterate next = newton_.search(step, last, change, search);
  if (!rule.may_solve_node || !has_stalled(next.error, last.error))
    return next;
  const auto nodes = nodes_to_solve(step, last, newton_.behind(step, last, change, 1), rule, allowances);
  if (nodes.empty())
    return next;
  const auto exact =
      with_exact_nodes(step, last.unknowns, last.displacement, conditions, *conditions_, change, nodes);
  if (!exact)
    return next;
  Iterate solved = newton_.behind(step, last, *exact, 1);
  return solved.error <= bearable_growth * next.error ? solved : next;
}

/// The residual of an iterate's forces, moved into their cones, with the displacement that they cause. If
/// they do not solve the step, the iterate becomes their state.
double InexactNewton::judge_forces(const ContactStep &step, Iterate &iterate, VectorXd &unknowns) const
{
  step.system().compliance().memory().remember(iterate.unknowns.head(iterate.displacement.size()),
                                               iterate.body);
  unknowns = step.admissible(iterate.unknowns);
  const double residual = step.residual(unknowns);
  if (residual > options_.tolerance)
    iterate = newton_.approximately_at(step, unknowns);
  return residual;
}

/// The share of the tolerance that a step must reach, where a share of `strictness` has left this residual:
/// in a tall body, the displacement that forces cause differs from the iterate's by more than the tolerance.
double stricter(const double strictness, const double tolerance, const double residual)
{
  constexpr double sure = 0.5, least = 0.1, strictest = 1e-3;
  return std::max(strictest, strictness * std::clamp(sure * tolerance / residual, least, sure));
}

SolverReport InexactNewton::solve(const ContactStep &step, VectorXd &unknowns) const
{
  constexpr double residual_share =
      0.3; // of the tolerance: the error of the displacement is up to 30 times as large
  const unsigned int most = std::min(options_.maximum_iterations, most_inexact_iterations);
  Trace trace;
  Globalization globalization;
  Allowances allowances = allowances_;
  if (is_unheld_without_forces(step, unknowns))
    unknowns = balancing_start(step);
  Iterate iterate = touching(step, newton_.approximately_at(step, unknowns));
  double residual = step.approximate_residual(unknowns);
  trace.add(0, residual, step.force_scale(unknowns));
  unsigned int n = 0;
  double strictness = 1;
  while (residual > options_.tolerance && n < most && std::isfinite(residual))
  {
    const double wanted = strictness * options_.tolerance * step.force_scale(iterate.unknowns);
    iterate = touching(step, next(step, iterate,
                                  globalization.next(iterate.linearization.error, iterate.error, wanted),
                                  allowances));
    ++n;
    residual = step.residual(iterate.unknowns, iterate.displacement);
    trace.add(n, residual, step.force_scale(iterate.unknowns));
    if (residual > options_.tolerance)
      continue;
    if (iterate.body_residual <= residual_share * wanted)
    {
      residual = judge_forces(step, iterate, unknowns);
      if (residual <= options_.tolerance)
        break;
      strictness = stricter(strictness, options_.tolerance, residual);
    }
    residual = std::max(2 * options_.tolerance, step.residual(iterate.unknowns, iterate.displacement));
  }
  if (!(residual <= options_.tolerance))
    unknowns = step.admissible(iterate.unknowns);
  return make_report(step, unknowns, n, options_.tolerance, std::move(trace));
}
} // namespace

std::unique_ptr<ContactSolver> make_inexact_newton(const ContactSystem &system,
                                                   const ContactSolverOptions &options,
                                                   const Allowances &allowances, Map *const map)
{
  return std::make_unique<InexactNewton>(system, options, allowances, map);
}
} // namespace orthocone
