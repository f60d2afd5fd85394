// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What users ask a run first, in the order in which they ask.
#pragma once

#include <orthocone/output/summary.h>

namespace orthocone
{
/// A result of the run.
struct Answer
{
  std::string name;  ///< of summary.json: "normal_force"
  std::string words; ///< "largest normal force"
  double value;
  std::string unit;  ///< "" for a ratio
  unsigned int step; ///< that had it; 0: at the end
};

/// Forces, areas, pressure, slip, friction, energies and wear, without those that the run does not have.
/// Energies are those of the last complete cycle, if there is one, and of the whole run.
std::vector<Answer> answers(const Summary &summary);

/// The answers as lines of a terminal of 80 columns.
std::string describe(const std::vector<Answer> &answers);
} // namespace orthocone
