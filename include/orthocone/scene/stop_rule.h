// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/choice.h>
#include <orthocone/scene/cycle_row.h>

namespace orthocone
{
struct LoadOptions;
struct WearOptions;

/// A rule that ends a run before the last cycle of its load program. All rules are there in every run. Each
/// has entries in section Load program, by which it is switched off unless they are set.
class StopRule
{
public:
  virtual ~StopRule() = default;
  virtual std::unique_ptr<StopRule> clone() const = 0;

  /// Adds the entries of the rule.
  virtual void declare(Section &section) = 0;

  /// Throws InputError where its entries contradict others.
  virtual void check(const LoadOptions &, const WearOptions &) const {}

  /// Adds warnings of values that are allowed; `tolerance` is that of the contact solver.
  virtual void warn(double /*tolerance*/, std::vector<std::string> &) const {}

  /// The change of state within which cycles count as alike in summary.json; 0: the rule does not ask that.
  virtual double periodic_within() const { return 0; }

  /// Why the run ends with the cycles of this row, a sentence for the log; "" where it goes on. The rule is
  /// asked at the end of every computed cycle and of every jump, and once more when a run is resumed there.
  virtual std::string why_to_stop(const CycleRow &row) const = 0;
};

template<>
std::vector<Kind<StopRule>> &kinds_of<StopRule>();
} // namespace orthocone
