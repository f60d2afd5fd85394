// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/step_solver.h>

#include <memory>
#include <optional>

namespace orthocone
{
/// The march of the same scene on the mesh before the last refinement, or on a grid of patches twice as long
/// and wide, with a loose tolerance and one step
/// ahead: the change of a step there gives its start on the finer mesh.
class CoarserMarch
{
public:
  /// The coarser march of a scene; null if its body has no coarser mesh, or does not need one.
  static std::unique_ptr<CoarserMarch> of(const Scene &finer);

  /// `parameters` have the coarser mesh.
  explicit CoarserMarch(const Parameters &parameters, const ModelChoice &choice);

  struct Change
  {
    Eigen::VectorXd displacement; ///< of the free degrees of freedom of the coarser mesh, mm, if there is one
    Eigen::VectorXd force;        ///< of the contact nodes of a coarser grid, in global axes, N
    RigidMotion motion;           ///< of the held face
    Eigen::VectorXd loads{};      ///< as ContactState::loads
  };

  /// Solves a step from the last accepted state; returns nothing if that fails.
  std::optional<Change> solve(const LoadStep &step);

  /// To be called when the step that was solved last is accepted.
  void accept(const LoadStep &step);

  /// StepSolver::remember_body().
  void remember_body() { solver_.remember_body(state_); }

  MarchMemory memory() const { return {state_, solver_.memory()}; }
  void restore(const MarchMemory &memory);

private:
  Scene scene_;
  StepSolver solver_;
  ContactState state_;
  std::optional<ContactState> solved_;
};
} // namespace orthocone
