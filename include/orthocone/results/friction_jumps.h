// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/friction_memory.h>

#include <memory>

namespace orthocone
{
/// The data of the last jump that the next one needs.
struct FrictionJumpMemory
{
  Eigen::VectorXd slip{};     ///< of the cycle that the last jump repeated, mm a node; empty before it
  Eigen::VectorXd energy{};   ///< dissipated in it, N mm a node
  unsigned int n_jumped = 0;  ///< cycles of the last jump
  unsigned int n_settled = 0; ///< cycles computed since
  double error = 0;           ///< of the mean factor of nodes that slip, by all jumps whose end is known
};

/// Chooses how many cycles of friction with memory are jumped, each of which slips and dissipates like the
/// last one. Error and length of a jump are found as those of WearJumps, with what the slip and the energy of
/// a cycle change in the factor in place of the worn depth (docs/theory.md, section 3, "Friction with
/// memory").
class FrictionJumps
{
public:
  /// No jumps.
  FrictionJumps() = default;

  /// `scene` must outlive it.
  explicit FrictionJumps(const Scene &scene);

  bool are_wanted() const { return friction_ != nullptr; }

  /// To be called with the states at both ends of every computed cycle, and its number. Returns how many
  /// cycles like it may follow, at most `most`.
  unsigned int after_cycle(const ContactState &start, const ContactState &end, unsigned int cycle,
                           unsigned int most);

  /// To be called with the same states where `n` cycles are jumped.
  void begin_jump(const ContactState &start, const ContactState &end, unsigned int n);

  const FrictionJumpMemory &memory() const { return memory_; }
  void restore(const FrictionJumpMemory &memory) { memory_ = memory; }

private:
  /// Slip and dissipated energy of a cycle at all nodes, mm and N mm.
  struct Rate
  {
    Eigen::VectorXd slip, energy;
  };
  Eigen::VectorXd behind(const ContactState &end, const Rate &rate, unsigned int n, unsigned int cycle) const;
  bool may_follow(const ContactState &end, const Rate &rate, unsigned int n, unsigned int cycle) const;
  unsigned int most_alike(const ContactState &end, const Rate &rate, unsigned int cycle,
                          unsigned int most) const;
  double growth(const ContactState &end, const Rate &rate, unsigned int cycle);

  std::shared_ptr<const FrictionMemory> friction_{};
  Eigen::VectorXd areas_{}; ///< of the nodes in the whole body, mm^2
  double largest_change_ = 0;
  unsigned int most_cycles_ = 0;
  FrictionJumpMemory memory_{};
};
} // namespace orthocone
