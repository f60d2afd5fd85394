// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/results/totals.h>

#include <array>
#include <utility>

namespace orthocone
{
/// Largest values over the run and the steps that had them, and the areas of contact and stick when the
/// tangential force was largest.
struct Peaks
{
  using Peak = std::pair<double, unsigned int>;

  Peak slip{0, 0};             ///< of nodes in contact, mm
  Peak pressure{0, 0};         ///< MPa
  Peak force_z{0, 0};          ///< N
  Peak tangential_force{0, 0}; ///< of the counterface on the body, N
  Peak friction{0,
                0}; ///< tangential over normal force, of steps with a thousandth of the largest one or more
  Peak contact_area{0, 0};    ///< mm^2
  Peak sheared_contact{0, 0}; ///< contact area when the tangential force was largest, mm^2
  Peak sheared_stick{0, 0};   ///< stick area then, mm^2

  unsigned int n_steps = 0; ///< since the start or the last interruption

  /// Takes over larger values of a step.
  void consider(unsigned int step, const Totals &totals);

  /// All peaks, in this order, to be stored and restored.
  std::array<Peak *, 8> all();
};
} // namespace orthocone
