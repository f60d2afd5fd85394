// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/choice.h>

namespace orthocone
{
/// A node's slip along the obstacle in one solved step.
struct Rubbing
{
  double normal_force = 0; ///< mean over the step, N; 0 counts for the time without contact
  double slip = 0;         ///< length of its way, mm
  double dissipated = 0;   ///< N mm
};

/// A law by which slip wears the base of the body (docs/theory.md, section 3, "Wear").
class WearKindOptions
{
public:
  virtual ~WearKindOptions() = default;
  virtual std::unique_ptr<WearKindOptions> clone() const = 0;

  /// Adds the entries of this law, which count where it is chosen.
  virtual void declare(Section &, const Condition & /*is_chosen*/) {}

  virtual bool wears() const { return true; }

  /// Volume that a node loses, mm^3; `coefficient` is the entry Coefficient, in 1/MPa. Deep steps take it to
  /// be in proportion to the normal force: they ask for that of 1 N.
  virtual double volume(double coefficient, const Rubbing &rubbing) const = 0;
};

template<>
std::vector<Kind<WearKindOptions>> &kinds_of<WearKindOptions>();
} // namespace orthocone
