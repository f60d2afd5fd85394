// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/march/friction_memory.h>
#include <orthocone/march/implicit_wear.h>
#include <orthocone/march/start_forces.h>
#include <orthocone/scene/scene.h>

#include <memory>
#include <optional>
#include <vector>

namespace orthocone
{
class CoarserMarch;

/// Solves load steps one after another. A step that fails is halved, from the state before it, so that the
/// slip history of the attempt is forgotten. At last it is tried undivided, from no force.
class StepSolver
{
public:
  /// Uses the scene's own contact solver, or the one of `options`. `scene` must outlive this object. Throws
  /// as make_contact_solver() does.
  explicit StepSolver(const Scene &scene);
  StepSolver(const Scene &scene, const ContactSolverOptions &options);
  StepSolver(StepSolver &&other) noexcept;
  ~StepSolver();

  /// Advances `state` to the end of `step`, in its parts if it has any. On failure (report.converged is
  /// false) `state` stays as it was. Throws SolveError where the body cannot be solved, or friction with
  /// memory has no coefficients.
  SolverReport solve(ContactState &state, const LoadStep &step);

  /// What the last call of solve() failed on: the problem of the whole step, or of its part
  /// (LoadStep::parts), before it was halved. Nothing if that call solved the step.
  const std::optional<ContactStep> &unsolved() const { return unsolved_; }

  /// The held face when the leg of a step began. `before` is the state before the step.
  FaceState leg_begin(const ContactState &before, const LoadStep &step) const;

  /// The share of its leg up to which a step without equilibrium can still be carried, from the state before
  /// the step. It is bisected to 1 % of the leg (docs/theory.md, section 3).
  double carried_share(const ContactState &before, const LoadStep &step) const;

  /// To be called with the states before and after every step that is accepted: later steps start from it.
  /// The parts of a step are accepted while it is solved.
  void accept(const ContactState &before, const ContactState &after, const LoadStep &step);

  /// To be called instead of accept() if the step that was solved last is not accepted: its parts are
  /// forgotten.
  void reject();

  /// Computes the body of an accepted state, where the remembered bodies are not known.
  void remember_body(const ContactState &state);

  /// The data with which a solver of the same problem goes on as this one would, and their return.
  const StartMemory &memory() const { return starts_.memory(); }
  void restore(const StartMemory &memory);

private:
  /// The problem of a step and what it came from.
  struct Attempt
  {
    FaceTarget target;
    ContactStep problem;
    std::vector<unsigned int> components; ///< of its free face
    Eigen::VectorXd worn{}; ///< depths that it wears and finds, mm; empty: the next one finds them

    /// The unknowns with the forces and motions of a state.
    Eigen::VectorXd unknowns_of(const ContactState &state) const
    {
      return orthocone::unknowns_of(with_motion(state), problem, components);
    }
  };

  SolverReport solve_in_one(ContactState &state, const LoadStep &step);
  void keep_bodies(const ContactState &state);
  void remember_last_cycle(const LoadStep &step);
  void accept_undivided(const ContactState &before, const ContactState &after, const LoadStep &step);
  Eigen::VectorXd start_of(const Attempt &attempt, const ContactState &state, const LoadStep &step);
  Attempt attempt(const ContactState &state, const FaceTarget &target) const;
  NodeVector free_displacement_with_wear(const ContactState &state, const FaceTarget &target) const;
  SolverReport solve_to(ContactState &state, const Attempt &attempt, Eigen::VectorXd unknowns,
                        unsigned int n_halvings) const;
  SolverReport accepted(ContactState &state, const Attempt &attempt, const Eigen::VectorXd &unknowns,
                        SolverReport report) const;
  void wear_implicitly(const ContactState &before, ContactState &state, const Attempt &attempt,
                       Eigen::VectorXd unknowns, SolverReport &report) const;
  SolverReport solve_from_no_force(ContactState &state, const Attempt &attempt,
                                   const SolverReport &failure) const;
  SolverReport solve_halves(ContactState &state, const FaceTarget &target, const SolverReport &failure,
                            unsigned int n_halvings) const;
  SolverReport release(ContactState &state, const Attempt &attempt) const;
  void accept_unknowns(ContactState &state, const Attempt &attempt, const Eigen::VectorXd &unknowns) const;

  const Scene &scene_;
  Eigen::VectorXd opening_; ///< node_compliance()
  WearLaw wear_;
  ImplicitWear implicit_wear_;
  FrictionMemory friction_;
  double tolerance_;
  std::unique_ptr<ContactSolver> solver_;
  StartForces starts_;
  std::unique_ptr<CoarserMarch> coarser_;     ///< where that pays
  unsigned long v_cycles_before_ = 0;         ///< before the step that was solved last
  std::optional<StartMemory> before_parts_{}; ///< of the step that was solved last, if it has parts
  std::optional<ContactStep> unsolved_{};
};
} // namespace orthocone
