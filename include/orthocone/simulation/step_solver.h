// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/contact_solver.h>
#include <orthocone/elasticity/condensed_body.h>
#include <orthocone/simulation/contact_state.h>
#include <orthocone/simulation/load_program.h>

#include <map>

namespace orthocone
{
/// Forces from which the next step may start, besides those of the last step.
struct StartMemory
{
  NodeVector change;                           ///< of the forces in the last step
  std::map<unsigned int, NodeVector> of_phase; ///< forces at each phase of the last cycle
  std::map<unsigned int, NodeVector> drift;    ///< their change from the cycle before that

  /// Most that both maps may hold. A cycle of so many steps that they would hold more starts its later phases
  /// from the step before.
  static constexpr std::size_t most_bytes = 32000000;
};

/// Chooses the forces from which a step starts: those of the last step, their extrapolation along the leg
/// (exact while the load is proportional), those at the same phase of the last cycle (exact once the response
/// is periodic), these with their drift from cycle to cycle, and none (exact at full unloading).
class StartForces
{
public:
  /// The first candidate whose residual is within the tolerance, which costs one product with W, or the one
  /// with the least.
  NodeVector best(const ContactProblem &problem, const ContactState &state, const LoadStep &step,
                  double tolerance) const;

  /// To be called with every solved step.
  void remember(const NodeVector &before, const NodeVector &after, const LoadStep &step);

  const StartMemory &memory() const { return memory_; }
  void restore(const StartMemory &memory) { memory_ = memory; }

private:
  StartMemory memory_;
};

/// Solves load steps one after another. A step that fails is halved, from the state before it, so that the
/// slip history of the attempt is forgotten.
class StepSolver
{
public:
  /// `opening`: opening_compliance().
  StepSolver(const CondensedBody &body, ContactProblem &problem, Eigen::VectorXd opening,
             const ContactSolverOptions &options);

  /// Advances `state` to the end of `step`. On failure (report.converged is false) `state` is as before.
  SolverReport solve(ContactState &state, const LoadStep &step) const;

  /// To be called with the states before and after every step that is accepted: later steps start from it.
  void accept(const ContactState &before, const ContactState &after, const LoadStep &step);

  /// What a solver of the same problem needs to go on as this one would.
  const StartMemory &memory() const { return starts_.memory(); }
  void restore(const StartMemory &memory) { starts_.restore(memory); }

private:
  SolverReport solve_to(ContactState &state, const std::array<double, 3> &top, NodeVector force,
                        unsigned int depth) const;
  void set_problem(const ContactState &state, const std::array<double, 3> &top) const;

  const CondensedBody &body_;
  ContactProblem &problem_;
  Eigen::VectorXd opening_;
  double tolerance_;
  std::unique_ptr<ContactSolver> solver_;
  StartForces starts_;
};
} // namespace orthocone
