// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/simulation/body.h>
#include <orthocone/simulation/model_choice.h>
#include <orthocone/simulation/step_solver.h>
#include <orthocone/simulation/summary.h>
#include <orthocone/simulation/totals.h>

#include <functional>

namespace orthocone
{
/// Everything from the mesh to the solver of load steps, for one choice of parameters: meshed, factorized and
/// condensed when it is constructed. Owns every module by value and keeps no state, so that several models
/// can be marched side by side, and without a run folder.
class ContactModel
{
public:
  /// `on_meshed` is called with the meshed body before the long work begins. Throws InputError, or
  /// std::runtime_error if the stiffness cannot be factorized.
  ContactModel(const Parameters &parameters, const ModelChoice &choice,
               const std::function<void(const Body &)> &on_meshed = {});
  ContactModel(const ContactModel &) = delete; // its modules refer to each other
  ContactModel &operator=(const ContactModel &) = delete;

  const ModelChoice &choice() const { return choice_; }
  const Body &body() const { return body_; }
  const ContactSurface &surface() const { return body_.unknowns().contact_surface(); }
  const Stiffness &stiffness() const { return stiffness_; }
  const CondensedBody &condensed() const { return condensed_; }
  const ContactProblem &problem() const { return problem_; }
  const ContactFieldEvaluator &evaluator() const { return evaluator_; }

  /// Its memory of earlier steps belongs to one march through a load program at a time.
  StepSolver &solver() { return solver_; }

  /// The body before the first step: unloaded, nothing remembered.
  ContactState initial_state() const { return ContactState(problem_.n_nodes()); }
  Totals totals(const ContactState &state) const;

  /// Wall time of mesh, assembly, factorization and condensation.
  const PhaseSeconds &seconds() const { return seconds_; }

private:
  const ModelChoice choice_;
  PhaseSeconds seconds_;
  Body body_;
  Stiffness stiffness_;
  StiffnessFactor factor_;
  SurfaceAxes axes_;
  CondensedBody condensed_;
  ContactProblem problem_;
  StepSolver solver_;
  ContactFieldEvaluator evaluator_;
};
} // namespace orthocone
