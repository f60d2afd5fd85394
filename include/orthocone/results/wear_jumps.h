// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/contact_state.h>

namespace orthocone
{
/// The data of the last jump that the next one needs.
struct WearMemory
{
  Eigen::VectorXd rate{};     ///< depth of the cycle that the last jump repeated, mm a node; empty before it
  unsigned int n_jumped = 0;  ///< cycles of the last jump
  unsigned int n_settled = 0; ///< cycles computed since
  double error = 0;           ///< of the worn volume, by all jumps whose end is known, mm^3
};

/// Chooses how many cycles of a surface that wears are jumped, each like the last one (docs/theory.md,
/// section 3, "Wear"). Behind a jump one cycle settles, as slip adapts to the new gaps, and the next one has
/// the new rate. The jump before and this one, with the new rate, are the two halves of a jump twice as long;
/// the difference between both halves and such a single jump is the error of a jump, and limits its length.
class WearJumps
{
public:
  /// `areas` are the areas of the nodes in the whole body, mm^2, one for each node of the model.
  WearJumps(const WearOptions &options, Eigen::VectorXd areas);

  bool are_wanted() const { return options_.wears() && options_.largest_jump > 0; }

  /// To be called with the states at both ends of every computed cycle. Returns how many cycles like it may
  /// follow, at most `most`.
  unsigned int after_cycle(const ContactState &start, const ContactState &end, unsigned int most);

  /// To be called where fewer cycles are jumped than that.
  void shorten(unsigned int n) { memory_.n_jumped = n; }

  const WearMemory &memory() const { return memory_; }
  void restore(const WearMemory &memory) { memory_ = memory; }

private:
  double growth(const Eigen::VectorXd &rate) const;

  WearOptions options_;
  Eigen::VectorXd areas_;
  WearMemory memory_;
};
} // namespace orthocone
