// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>
#include <orthocone/march/contact_state.h>
#include <orthocone/scene/load_program.h>

#include <map>
#include <utility>
#include <vector>

namespace orthocone
{
struct MarchMemory;

/// Forces from which the next step may start, besides the forces of the last step. Each vector has three
/// forces a node (N), and behind them the motion of the held face (mm and rad) and the loads.
struct StartMemory
{
  NodeVector change;                           ///< of the forces in the last step
  std::map<unsigned int, NodeVector> of_phase; ///< forces at each phase of the last cycle
  std::map<unsigned int, NodeVector> drift;    ///< their change from the cycle before
  std::vector<Eigen::VectorXd> bodies{};       ///< SolutionMemory::forget_trials()
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

/// Forces of a state, and the motion of the held face and the loads behind them, as StartMemory has them.
NodeVector with_motion(const ContactState &state);

/// Turns such a vector into unknowns of a step whose face has these components.
Eigen::VectorXd unknowns_of(const NodeVector &all, const ContactStep &problem,
                            const std::vector<unsigned int> &components);

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
} // namespace orthocone
