// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "pressure_first_steps.h"

#include <algorithm>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// The iterate with the least error so far.
class Best
{
public:
  explicit Best(const Iterate &start)
      : unknowns_(start.unknowns),
        error_(start.linearization.error)
  {
  }

  /// Returns whether an iterate is better than all before.
  bool offer(const Iterate &iterate, const unsigned int number)
  {
    if (!(iterate.linearization.error < error_))
      return false;
    unknowns_ = iterate.unknowns;
    error_ = iterate.linearization.error;
    number_ = number;
    return true;
  }

  unsigned int number() const { return number_; }
  VectorXd take() { return std::move(unknowns_); }

private:
  VectorXd unknowns_;
  double error_; ///< of the map, N
  unsigned int number_ = 0;
};
} // namespace

PressureFirstSteps::PressureFirstSteps(const ContactSolverOptions &options, const ConditionSolver &conditions,
                                       const HardestNodes *const hardest_nodes)
    : options_(options),
      conditions_(conditions),
      hardest_nodes_(hardest_nodes)
{
}

/// Takes the state in which the hardest nodes are solved, and returns whether it has. For the other nodes
/// that state is worse as a rule. Newton's next steps mend this, while no step of the whole surface gets the
/// hardest nodes off their corners.
bool PressureFirstSteps::pass_hardest_nodes(NewtonProgress &progress, Iterate &last,
                                            const bool may_be_worse) const
{
  constexpr double bearable_growth = 1000;
  if (hardest_nodes_ == nullptr)
    return false;
  HardestNodes::Result solved = hardest_nodes_->solve(progress.step, last.unknowns, last.displacement);
  progress.iterations += solved.iterations;
  if (!solved.unknowns)
    return false;
  NodeVector displacement = progress.step.displacement(*solved.unknowns);
  Iterate next(linearize, progress.step, *std::move(solved.unknowns), std::move(displacement),
               options_.rho_factor);
  if (!(next.linearization.error < (may_be_worse ? bearable_growth : 1) * last.linearization.error))
    return false;
  last = std::move(next);
  return true;
}

Iterate PressureFirstSteps::start(const NewtonProgress &progress) const
{
  return {linearize, progress.step, progress.unknowns, progress.step.displacement(progress.unknowns),
          options_.rho_factor};
}

/// The line search takes the shortest step where none reduces the map: that passes corners where pieces of it
/// meet.
void PressureFirstSteps::iterate(NewtonProgress &progress) const
{
  constexpr unsigned int most_iterations = 30, most_without_gain = 5;
  // The residual projects every node. The map's own error says without that where it may be small enough.
  constexpr unsigned int interval = 4;
  constexpr double likely = 10;                           // tolerances
  constexpr double smallest_step = 1. / 16, stalls = 0.5; // of the error before: few nodes hold up the others
  constexpr unsigned int pause = 3; // iterations that may mend what the hardest nodes have made worse
  const ContactStep &step = progress.step;
  Iterate last = start(progress);
  Best best(last);
  unsigned int stalls_in_a_row = 0;
  for (unsigned int i = 0, i_passed = 0; i < most_iterations && i <= best.number() + most_without_gain &&
                                         progress.iterations < options_.maximum_iterations;
       ++i)
  {
    const double inexactness =
        stalls_in_a_row < stalls_before_exactness ? inexactness_of_newton : inexactness_of_stalled_newton;
    const VectorXd change = newton_change(conditions_, last.linearization, inexactness);
    ++progress.iterations;
    if (!change.allFinite())
      break;
    const double error_before = last.linearization.error;
    last = line_search(linearize, step, last, change, smallest_step, options_.rho_factor);
    const double near = likely * options_.tolerance * step.force_scale(last.unknowns);
    const bool has_stalled = last.linearization.error > stalls * error_before;
    stalls_in_a_row = has_stalled ? stalls_in_a_row + 1 : 0;
    if (has_stalled && last.linearization.error > near &&
        pass_hardest_nodes(progress, last, i_passed == 0 || i >= i_passed + pause))
      i_passed = i;
    const bool is_near = last.linearization.error <= near;
    const bool is_better = best.offer(last, i);
    if (!is_near && i % interval != interval - 1)
      continue;
    const double residual = step.residual(last.unknowns, last.displacement);
    progress.note(residual, last.unknowns);
    if (is_better && residual <= options_.tolerance)
      break;
  }
  progress.offer(step.admissible(best.take()));
}
} // namespace orthocone
