// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "exact_nodes.h"
#include "few_nodes.h"
#include "line_search.h"
#include "loose_face.h"
#include "solvers.h"
#include "step_choices.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// Unknowns, their displacement, the body behind them, and the law linearized there.
struct BodyIterate
{
  BodyIterate(Map *const map, const ContactStep &step, VectorXd unknowns_, NodeVector displacement_,
              BodyPart body_, const double rho_factor)
      : unknowns(std::move(unknowns_)),
        displacement(std::move(displacement_)),
        body(std::move(body_)),
        linearization(map(step, unknowns, displacement, rho_factor)),
        rest_norm(step.system().compliance().norm(body.rest)),
        error(std::hypot(linearization.error, rest_norm))
  {
    linearization.conditions.rest = body.rest;
  }

  VectorXd unknowns;
  NodeVector displacement;
  BodyPart body;
  Linearization linearization;
  double rest_norm; ///< of what the body lacks, N
  double error;     ///< of the law and of the body's equilibrium, N
};

/// Whether the error behind a step of this length is so far below the bound that the step pays.
bool is_low(const double error, const double length, const double bound)
{
  constexpr double sufficient_decrease = 1e-4;
  return error <= (1 - sufficient_decrease * length) * bound;
}

/// Semismooth Newton for a body without a dense compliance: linearized laws are solved on the whole body, and
/// only as accurately as it pays. There are no sweeps. docs/theory.md, section 3, "A body without a matrix".
class InexactNewton : public ContactSolver
{
public:
  InexactNewton(const ContactSystem &system, const ContactSolverOptions &options,
                const Allowances &allowances, Map *const map)
      : options_(options),
        allowances_(allowances),
        map_(map),
        conditions_(condition_solver(system, "newton"))
  {
  }

  SolverReport solve(const ContactStep &step, VectorXd &unknowns) const override;

private:
  BodyIterate near(const ContactStep &step, const VectorXd &unknowns) const
  {
    ContactChange near = step.near(unknowns);
    return {map_, step, unknowns, std::move(near.displacement), std::move(near.body), options_.rho_factor};
  }
  BodyIterate touching(const ContactStep &step, BodyIterate iterate) const;
  BodyIterate behind(const ContactStep &step, const BodyIterate &last, const ContactChange &change,
                     double length) const;
  BodyIterate share_of(const ContactChange &change, const ContactStep &step, const BodyIterate &last,
                       const StepChoice &choice, Allowances &allowances) const;
  static std::vector<Eigen::Index> nodes_to_solve(const ContactStep &step, const BodyIterate &last,
                                                  const BodyIterate &full, const StepChoice &choice,
                                                  Allowances &allowances);
  BodyIterate next(const ContactStep &step, const BodyIterate &last, const StepChoice &choice,
                   Allowances &allowances) const;
  double judge_forces(const ContactStep &step, BodyIterate &iterate, VectorXd &unknowns) const;

  ContactSolverOptions options_;
  Allowances allowances_;
  Map *map_;
  std::unique_ptr<ConditionSolver> conditions_;
};

/// The iterate, with a loose face moved until nodes hold it. Those that hold it first may let it tilt.
BodyIterate InexactNewton::touching(const ContactStep &step, BodyIterate iterate) const
{
  for (Eigen::Index i = 0; i < step.face().n(); ++i)
  {
    const VectorXd way = way_of_loose_face(step, iterate.unknowns, iterate.displacement,
                                           iterate.linearization.conditions, options_.rho_factor);
    if (way.size() == 0)
      break;
    iterate.unknowns.tail(way.size()) += way;
    iterate = {map_,
               step,
               std::move(iterate.unknowns),
               iterate.displacement + step.face().columns() * way,
               std::move(iterate.body),
               options_.rho_factor};
  }
  return iterate;
}

/// The iterate behind a change, or behind a share of it.
BodyIterate InexactNewton::behind(const ContactStep &step, const BodyIterate &last,
                                  const ContactChange &change, const double length) const
{
  return {map_,
          step,
          last.unknowns + length * unknowns_of(change),
          last.displacement + length * change.displacement,
          last.body.moved(length, change.body),
          options_.rho_factor};
}

/// Newton's change, or the share of it whose error is below the bound. Where neither all nor half of it is,
/// pieces of the map meet, or the error has a minimum beside the solution, in which shorter steps would end.
/// Then it is all of it a few times near the solution. Else it is the share with the least error if that is
/// little worse than the last error, and all of it otherwise.
BodyIterate InexactNewton::share_of(const ContactChange &change, const ContactStep &step,
                                    const BodyIterate &last, const StepChoice &choice,
                                    Allowances &allowances) const
{
  constexpr double smallest_step = 1. / 64, bearable_growth = 1.2, bearable_leap = 10;
  BodyIterate full = behind(step, last, change, 1);
  if (is_low(full.error, 1, choice.bound))
    return full;
  BodyIterate best = behind(step, last, change, 0.5);
  if (is_low(best.error, 0.5, choice.bound))
    return best;
  if (choice.may_leap && allowances.leaps > 0 && full.error <= bearable_leap * choice.bound)
  {
    --allowances.leaps;
    return full;
  }
  for (double length = 0.25; length >= smallest_step; length /= 2)
  {
    BodyIterate tried = behind(step, last, change, length);
    if (is_low(tried.error, length, choice.bound))
      return tried;
    if (tried.error < best.error)
      best = std::move(tried);
  }
  return best.error <= std::min(full.error, bearable_growth * last.error) ? best : full;
}

/// The nodes that are to be solved exactly: the hardest one behind a full step, if there is one, a few times.
/// Where that has not helped, those few that are hardest behind or before the step. They may be in a row in
/// which each one slips when its neighbour does. None where the error is on many nodes.
std::vector<Eigen::Index> InexactNewton::nodes_to_solve(const ContactStep &step, const BodyIterate &last,
                                                        const BodyIterate &full, const StepChoice &choice,
                                                        Allowances &allowances)
{
  constexpr std::size_t few = 4;
  const auto node = hardest_node(step, full.unknowns, full.displacement);
  if (node && allowances.exact_nodes > 0)
  {
    --allowances.exact_nodes;
    return {*node};
  }
  std::vector<Eigen::Index> nodes = worst_nodes(step, full.unknowns, full.displacement, few + 1);
  if (nodes.size() > few || !choice.may_solve_nodes)
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
BodyIterate InexactNewton::next(const ContactStep &step, const BodyIterate &last, const StepChoice &choice,
                                Allowances &allowances) const
{
  constexpr double bearable_growth = 100;
  const ContactConditions &conditions = last.linearization.conditions;
  const ContactChange change = with_displacement(step, conditions_->solve(conditions, choice.accuracy));
  BodyIterate next = share_of(change, step, last, choice, allowances);
  if (!choice.may_solve_node || !has_stalled(next.error, last.error))
    return next;
  const auto nodes = nodes_to_solve(step, last, behind(step, last, change, 1), choice, allowances);
  if (nodes.empty())
    return next;
  const auto exact =
      with_exact_nodes(step, last.unknowns, last.displacement, conditions, *conditions_, change, nodes);
  if (!exact)
    return next;
  BodyIterate solved = behind(step, last, *exact, 1);
  return solved.error <= bearable_growth * next.error ? solved : next;
}

/// The residual of an iterate's forces, moved into their cones, with the displacement that they cause. If
/// they do not solve the step, the iterate becomes their state.
double InexactNewton::judge_forces(const ContactStep &step, BodyIterate &iterate, VectorXd &unknowns) const
{
  step.system().compliance().learn(iterate.unknowns.head(iterate.displacement.size()), iterate.body);
  unknowns = step.admissible(iterate.unknowns);
  const double residual = step.residual(unknowns);
  if (residual > options_.tolerance)
    iterate = near(step, unknowns);
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
  constexpr double rest_share =
      0.3; // of the tolerance: the error of the displacement is up to 30 times as large
  const unsigned int most = std::min(options_.maximum_iterations, most_inexact_iterations);
  Trace trace;
  StepChoices choices;
  Allowances allowances = allowances_;
  if (is_loose_without_forces(step, unknowns))
    unknowns = balancing_start(step);
  BodyIterate iterate = touching(step, near(step, unknowns));
  double residual = step.near_residual(unknowns);
  trace.add(0, residual, step.force_scale(unknowns));
  unsigned int n = 0;
  double strictness = 1;
  while (residual > options_.tolerance && n < most && std::isfinite(residual))
  {
    const double wanted = strictness * options_.tolerance * step.force_scale(iterate.unknowns);
    iterate =
        touching(step, next(step, iterate, choices.next(iterate.linearization.error, iterate.error, wanted),
                            allowances));
    ++n;
    residual = step.residual(iterate.unknowns, iterate.displacement);
    trace.add(n, residual, step.force_scale(iterate.unknowns));
    if (residual > options_.tolerance)
      continue;
    if (iterate.rest_norm <= rest_share * wanted)
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
                                                   const Allowances &allowances)
{
  return std::make_unique<InexactNewton>(system, options, allowances, linearize);
}

} // namespace orthocone
