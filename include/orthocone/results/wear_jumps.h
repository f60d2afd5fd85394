// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/contact_state.h>

namespace orthocone
{
/// What the next jump needs to know of the last one.
struct WearMemory
{
  Eigen::VectorXd rate{};     ///< depth of the cycle that the last jump repeated, mm a node; empty before it
  unsigned int n_jumped = 0;  ///< cycles of the last jump
  unsigned int n_settled = 0; ///< cycles computed since
  double error = 0;           ///< of the worn volume by all jumps whose end is known, mm^3
};

/// How many cycles of a surface that wears are jumped, each like the last one. Behind a jump one cycle
/// settles, as slip takes up the new gaps, and the next one has the new rate. The jump before, taken again
/// with the new rate, would have been the second half of one twice as long; the difference between both
/// halves and one such jump is what a jump errs by, and keeps its length.
class WearJumps
{
public:
  /// `areas`: those of the nodes in the whole body, mm^2.
  WearJumps(const WearOptions &options, Eigen::VectorXd areas);

  bool are_wanted() const { return options_.law != WearKind::none && options_.largest_jump > 0; }

  /// To be called with the states at both ends of every computed cycle. Returns how many cycles like it may
  /// follow, at most `most`.
  unsigned int after_cycle(const ContactState &start, const ContactState &end, unsigned int most);

  const WearMemory &memory() const { return memory_; }
  void restore(const WearMemory &memory) { memory_ = memory; }

private:
  double growth(const Eigen::VectorXd &rate) const;

  WearOptions options_;
  Eigen::VectorXd areas_;
  WearMemory memory_;
};
} // namespace orthocone
