// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/codec.h>
#include <orthocone/entries/formula.h>

#include <optional>

namespace orthocone
{
/// What friction of a node may depend on, besides its place: the state behind the last step.
struct FrictionHistory
{
  double slip = 0;        ///< length of the path of slip since the start, mm
  double energy = 0;      ///< that friction has dissipated per area since the start, N/mm
  double pressure = 0;    ///< MPa
  double speed = 0;       ///< of slip in the last step, mm/s
  bool slipped = false;   ///< in the last step
  unsigned int cycle = 0; ///< of the step to come
};

/// The number by which the coefficients of friction are multiplied in a step, the entry Factor: an expression
/// of the state before the step (docs/theory.md, section 3, "Friction with memory").
class FrictionFactor
{
public:
  /// The factor 1.
  FrictionFactor() = default;

  /// Throws InputError for a text that is no expression of s, w, p, v, k and n.
  explicit FrictionFactor(const std::string &text);

  /// Whether it is the number 1, so that there is nothing to do.
  bool is_one() const { return !formula_; }

  /// Whether it changes while forces and motions repeat themselves.
  bool remembers() const { return formula_ && (formula_->has(0) || formula_->has(1) || formula_->has(5)); }
  bool has_speed() const { return formula_ && formula_->has(3); }
  /// Whether friction may fall, or rise, when a node begins to slip.
  bool is_static_and_kinetic() const { return formula_ && formula_->has(4); }
  bool is_constant() const { return !formula_ || formula_->is_constant(); }

  /// Any number, also infinite or NaN.
  double value(const FrictionHistory &history) const;

  /// The factor of the first step, in this cycle.
  double at_start(const unsigned int cycle) const { return value({0, 0, 0, 0, false, cycle}); }

  /// Whether coefficients may be multiplied by such a number.
  static bool is_fine(const double factor) { return positive.contains(factor); }

  std::string text() const { return formula_ ? formula_->text() : "1"; }

private:
  std::optional<Formula> formula_{};
};

/// A number > 0, or an expression of s, w, p, v, k and n.
Codec<FrictionFactor> factor_codec();
} // namespace orthocone
