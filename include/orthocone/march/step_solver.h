// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/solvers/contact_solver.h>
#include <orthocone/march/contact_state.h>
#include <orthocone/march/implicit_wear.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/scene.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace orthocone
{
struct MarchMemory;

/// Forces from which the next step may start, besides the forces of the last step. Each vector has three
/// forces a node (N), and behind them the motion of the held face (mm and rad).
struct StartMemory
{
  NodeVector change;                           ///< of the forces in the last step
  std::map<unsigned int, NodeVector> of_phase; ///< forces at each phase of the last cycle
  std::map<unsigned int, NodeVector> drift;    ///< their change from the cycle before
  std::vector<Eigen::VectorXd> bodies{};       ///< Compliance::forget_trials()
  std::vector<MarchMemory> coarser{};          ///< of CoarserMarch; one, or none
  /// Bodies at phases of the last cycle where it took work to find them. With forces that come back they come
  /// back, too.
  std::map<unsigned int, Eigen::VectorXd> body_of_phase{};

  /// The largest size of both maps. If a cycle has so many steps that they would exceed it, its later phases
  /// start from the step before.
  static constexpr std::size_t most_bytes = 32000000;
  /// The largest size of the bodies of phases, over all processes. Later phases of the cycle have none.
  static constexpr std::size_t most_body_bytes = 32000000;
};

/// The data from which a march goes on.
struct MarchMemory
{
  ContactState state;
  StartMemory starts;
};

/// Chooses the forces from which a step starts: those of the last step, their extrapolation along the leg
/// (exact while the load is proportional), those at the same phase of the last cycle (exact once the response
/// is periodic), these with their drift from cycle to cycle, and none (exact at full unloading).
class StartForces
{
public:
  /// Unknowns of `problem`, whose face has these components: the first candidate whose residual is within the
  /// tolerance, or the candidate with the least residual. A likely candidate costs one product with W, any
  /// other one ContactStep::approximate_residual().
  Eigen::VectorXd best(const ContactStep &problem, const std::vector<unsigned int> &components,
                       const ContactState &state, const LoadStep &step, double tolerance) const;

  /// To be called with every solved step.
  void remember(const ContactState &before, const ContactState &after, const LoadStep &step);

  const StartMemory &memory() const { return memory_; }
  void restore(const StartMemory &memory) { memory_ = memory; }
  void keep(std::vector<Eigen::VectorXd> bodies, std::vector<MarchMemory> coarser)
  {
    memory_.bodies = std::move(bodies);
    memory_.coarser = std::move(coarser);
  }

  /// To be called behind keep() with a step under forces: the last of the bodies is its own. `is_dear`: it
  /// took work to find. All processes must call it.
  void keep_body(const LoadStep &step, bool is_dear);

  /// The body at the phase of a step in the last cycle, or null.
  const Eigen::VectorXd *body_of(const LoadStep &step) const;

private:
  struct Candidate
  {
    NodeVector all;         ///< as in StartMemory
    bool is_likely = false; ///< to be the answer: its residual is worth a product with W
  };
  std::vector<Candidate> candidates_for(const ContactState &state, const LoadStep &step) const;

  StartMemory memory_;
};

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
  /// false) `state` stays as it was. Throws SolveError where the body cannot be solved.
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
  void wear_implicitly(const ContactState &before, ContactState &state, const Attempt &attempt,
                       Eigen::VectorXd unknowns, SolverReport &report) const;
  SolverReport solve_from_no_force(ContactState &state, const Attempt &attempt,
                                   const SolverReport &failure) const;
  SolverReport solve_halves(ContactState &state, const FaceTarget &target, const SolverReport &failure,
                            unsigned int n_halvings) const;
  SolverReport release(ContactState &state, const Attempt &attempt) const;
  void accept_unknowns(ContactState &state, const Attempt &attempt, const Eigen::VectorXd &unknowns) const;
  Eigen::VectorXd present_unknowns(const ContactState &state, const Attempt &attempt) const;

  const Scene &scene_;
  Eigen::VectorXd opening_; ///< node_compliance()
  WearLaw wear_;
  ImplicitWear implicit_wear_;
  double tolerance_;
  std::unique_ptr<ContactSolver> solver_;
  StartForces starts_;
  std::unique_ptr<CoarserMarch> coarser_;     ///< where that pays
  unsigned long v_cycles_before_ = 0;         ///< before the step that was solved last
  std::optional<StartMemory> before_parts_{}; ///< of the step that was solved last, if it has parts
  std::optional<ContactStep> unsolved_{};
};
} // namespace orthocone
