// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/step_solver.h>

#include <algorithm>
#include <memory>

namespace orthocone
{
using Eigen::Index;
using Eigen::VectorXd;

namespace
{
/// The least motion along the normal that leaves no node under pressure, mm.
double opening_motion(const NodeVector &free_gap)
{
  double motion = -free_gap[0];
  for (Index i = 0; i < free_gap.size(); i += 3)
    motion = std::max(motion, -free_gap[i]);
  return motion;
}
} // namespace

/// Nothing presses, so that there are no contact forces. This leaves the motion undetermined; taken is the
/// first one on the way at which the forces vanish (docs/theory.md, section 3).
SolverReport StepSolver::release(ContactState &state, const Attempt &attempt) const
{
  constexpr unsigned int normal = 2;
  FaceTarget open{{}, attempt.target.motion, {}};
  for (const unsigned int component : attempt.components)
    open.motion[component] = component == normal ? 0 : state.motion[component];
  open.motion[normal] = opening_motion(free_displacement_with_wear(state, open));
  const Attempt apart = this->attempt(state, open);
  const VectorXd none = VectorXd::Zero(apart.problem.n_unknowns());
  SolverReport report = make_report(apart.problem, none, 0, tolerance_);
  report.is_released = true;
  if (report.converged)
  {
    accept_unknowns(state, apart, none);
    report.last_part = std::make_shared<const SolvedProblem>(SolvedProblem{apart.problem, none});
  }
  return report;
}
} // namespace orthocone
