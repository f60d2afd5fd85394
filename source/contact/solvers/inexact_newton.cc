// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "line_search.h"
#include "loose_face.h"
#include "solvers.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// How accurately the next linear system is solved: as accurately as Newton's method converges on the law,
/// which is all that is not linear, and no better than the tolerance asks for.
class Forcing
{
public:
  double next(const BodyIterate &iterate, const double wanted)
  {
    constexpr double coarse = 0.3, fine = 1e-2, oversolving = 0.05;
    const double of_law = iterate.linearization.error;
    const double reduction = last_ > 0 ? of_law / last_ : 1;
    last_ = of_law;
    return std::max(std::clamp(0.9 * reduction * reduction, fine, coarse),
                    oversolving * wanted / iterate.error);
  }

private:
  double last_ = 0; ///< error of the law
};

/// The error that a step must stay below. Near the solution it is the larger one of the last two errors.
/// Where slip is far from associated, the error may have a minimum beside the solution. Only a step across
/// the ridge between both leads out of it (Grippo, Lampariello and Lucidi, SIAM J. Numer. Anal. 23 (1986)
/// 707). Far from the solution such steps cost more than they save. docs/performance.md, "Multigrid".
class Ridge
{
public:
  double height(const double error)
  {
    constexpr double near = 1e-3; // of the first error
    if (first_ == 0)
      first_ = error;
    const double before = std::exchange(last_, error);
    return error <= near * first_ ? std::max(before, error) : error;
  }

private:
  double first_ = 0, last_ = 0;
};

/// Semismooth Newton for a body without a dense compliance: linearized laws are solved on the whole body, and
/// only as accurately as it pays. There are no sweeps. docs/theory.md, section 3, "A body without a matrix".
class InexactNewton : public ContactSolver
{
public:
  InexactNewton(const ContactSystem &system, const ContactSolverOptions &options, Map *const map)
      : options_(options),
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
  BodyIterate next(const ContactStep &step, const BodyIterate &last, double accuracy, double bound) const;
  bool is_solved(const ContactStep &step, BodyIterate &iterate, VectorXd &unknowns) const;

  ContactSolverOptions options_;
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

/// Newton's change, or the share of it whose error is below the bound. Where none is, pieces of the map
/// meet: then it is the share with the least error if that is little worse than the last error, else all of
/// it.
BodyIterate InexactNewton::next(const ContactStep &step, const BodyIterate &last, const double accuracy,
                                const double bound) const
{
  constexpr double sufficient_decrease = 1e-4, smallest_step = 1. / 64, bearable_growth = 1.2;
  ContactChange change = conditions_->solve(last.linearization.conditions, accuracy);
  VectorXd moved(change.force.size() + change.face.size());
  moved << change.force, change.face;
  if (change.displacement.size() == 0)
    change.displacement = step.change_of_displacement(moved);
  const auto trial = [&](const double length)
  {
    return BodyIterate(map_, step, last.unknowns + length * moved,
                       last.displacement + length * change.displacement, last.body.moved(length, change.body),
                       options_.rho_factor);
  };
  BodyIterate best = trial(1);
  for (double length = 1; length >= smallest_step; length /= 2)
  {
    BodyIterate tried = length == 1 ? best : trial(length);
    if (tried.error <= (1 - sufficient_decrease * length) * bound)
      return tried;
    if (tried.error < best.error)
      best = std::move(tried);
  }
  return best.error <= bearable_growth * last.error ? best : trial(1);
}

/// Whether the forces of an iterate, moved into their cones, solve the step with the displacement that they
/// cause. If not, the iterate becomes the state of these forces.
bool InexactNewton::is_solved(const ContactStep &step, BodyIterate &iterate, VectorXd &unknowns) const
{
  step.system().compliance().learn(iterate.unknowns.head(iterate.displacement.size()), iterate.body);
  unknowns = step.admissible(iterate.unknowns);
  if (step.residual(unknowns) <= options_.tolerance)
    return true;
  iterate = near(step, unknowns);
  return false;
}

SolverReport InexactNewton::solve(const ContactStep &step, VectorXd &unknowns) const
{
  constexpr double rest_share =
      0.3; // of the tolerance: the error of the displacement is up to 30 times as large
  // In a tall body it is larger still: where the forces do not solve the step with the displacement that they
  // cause, the body must come closer to its equilibrium.
  constexpr double stricter = 0.1, strictest = 1e-3;
  const unsigned int most = std::min(options_.maximum_iterations, most_inexact_iterations);
  Trace trace;
  Forcing forcing;
  Ridge ridge;
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
    iterate = touching(step, next(step, iterate, forcing.next(iterate, wanted), ridge.height(iterate.error)));
    ++n;
    residual = step.residual(iterate.unknowns, iterate.displacement);
    trace.add(n, residual, step.force_scale(iterate.unknowns));
    if (residual > options_.tolerance)
      continue;
    if (iterate.rest_norm <= rest_share * wanted)
    {
      if (is_solved(step, iterate, unknowns))
        break;
      strictness = std::max(strictest, stricter * strictness);
    }
    residual = std::max(2 * options_.tolerance, step.residual(iterate.unknowns, iterate.displacement));
  }
  if (!(residual <= options_.tolerance))
    unknowns = step.admissible(iterate.unknowns);
  return make_report(step, unknowns, n, options_.tolerance, std::move(trace));
}
} // namespace

std::unique_ptr<ContactSolver> make_inexact_newton(const ContactSystem &system,
                                                   const ContactSolverOptions &options)
{
  return std::make_unique<InexactNewton>(system, options, linearize_pressure_first);
}

std::unique_ptr<ContactSolver> make_natural_newton(const ContactSystem &system,
                                                   const ContactSolverOptions &options)
{
  return std::make_unique<InexactNewton>(system, options, linearize);
}
} // namespace orthocone
