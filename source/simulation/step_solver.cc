// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/step_solver.h>

#include <limits>
#include <utility>

namespace orthocone
{
NodeVector StartForces::best(const ContactProblem &problem, const ContactState &state, const LoadStep &step,
                             const double tolerance) const
{
  std::vector<NodeVector> candidates;
  if (const auto last_cycle = memory_.of_phase.find(step.phase);
      step.cycle > 0 && last_cycle != memory_.of_phase.end()) // in the first cycle: of the search for a mesh
  {
    candidates.push_back(last_cycle->second);
    if (const auto drift = memory_.drift.find(step.phase); drift != memory_.drift.end())
      candidates.push_back(last_cycle->second + drift->second);
  }
  if (step.step_of_leg > 1)
    candidates.push_back(state.force + memory_.change);
  candidates.push_back(NodeVector::Zero(state.force.size())); // full unloading
  candidates.push_back(state.force);
  double least = std::numeric_limits<double>::infinity();
  std::size_t best = candidates.size() - 1;
  for (std::size_t i = 0; i < candidates.size() && least > tolerance; ++i)
    if (const double residual = problem.residual(candidates[i]); residual < least)
    {
      least = residual;
      best = i;
    }
  if (least > tolerance)
    return candidates[best];
  // This is the solution then. A sum of forces leaves the cone by rounding, which the residual does not see
  // where friction is next to nothing.
  NodeVector inside = problem.admissible(candidates[best]);
  return problem.residual(inside) <= tolerance ? inside : candidates[best];
}

void StartForces::remember(const NodeVector &before, const NodeVector &after, const LoadStep &step)
{
  memory_.change = after - before;
  if (step.cycle == 0)
    return;
  const std::size_t bytes = after.size() * sizeof(double);
  if (2 * bytes * (memory_.of_phase.size() + 1) > StartMemory::most_bytes &&
      memory_.of_phase.count(step.phase) == 0)
    return;
  NodeVector &of_phase = memory_.of_phase[step.phase];
  if (of_phase.size() > 0)
    memory_.drift[step.phase] = after - of_phase;
  of_phase = after;
}

StepSolver::StepSolver(const CondensedBody &body, ContactProblem &problem, Eigen::VectorXd opening,
                       const ContactSolverOptions &options)
    : body_(body),
      problem_(problem),
      opening_(std::move(opening)),
      tolerance_(options.tolerance),
      solver_(make_contact_solver(problem, options))
{
}

void StepSolver::set_problem(const ContactState &state, const std::array<double, 3> &top) const
{
  problem_.set_step(body_.free_displacement(top), state.displacement);
}

SolverReport StepSolver::solve(ContactState &state, const LoadStep &step) const
{
  const ContactState before = state;
  set_problem(state, step.top);
  const SolverReport report = solve_to(state, step.top, starts_.best(problem_, state, step, tolerance_), 0);
  if (report.converged)
    state.step = step.number;
  else
    state = before;
  return report;
}

void StepSolver::accept(const ContactState &before, const ContactState &after, const LoadStep &step)
{
  starts_.remember(before.force, after.force, step);
}

SolverReport StepSolver::solve_to(ContactState &state, const std::array<double, 3> &top, NodeVector force,
                                  const unsigned int depth) const
{
  constexpr unsigned int most_halvings = 3;
  set_problem(state, top);
  SolverReport report = solver_->solve(force);
  if (report.converged)
  {
    advance(state, problem_, opening_, force, top);
    return report;
  }
  if (depth == most_halvings)
    return report;
  std::array<double, 3> middle{};
  for (unsigned int d = 0; d < 3; ++d)
    middle[d] = 0.5 * (state.top[d] + top[d]);
  const unsigned int spent = report.iterations;
  const SolverReport first = solve_to(state, middle, state.force, depth + 1);
  report = first.converged ? solve_to(state, top, state.force, depth + 1) : first;
  report.iterations += spent + (first.converged ? first.iterations : 0);
  report.n_parts += first.n_parts;
  report.law.merge(first.law);
  return report;
}
} // namespace orthocone
