// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

namespace orthocone
{
/// One load step: where the top stands at its end, and its place in the program.
struct LoadStep
{
  std::array<double, 3> top; ///< ux, uy, uz in mm
  unsigned int number;       ///< counted from 1
  unsigned int step_of_leg;  ///< counted from 1
  unsigned int cycle;        ///< counted from 1; 0 in the preload
  unsigned int phase;        ///< step of the cycle (or of the preload), counted from 0
};

/// All steps of a load program, in order. Cycles repeat the same positions to the last bit.
std::vector<LoadStep> load_steps(const LoadOptions &load);

/// Largest |u| over the corners of the program in a direction (0: x, 1: y, 2: z).
double largest_motion(const LoadOptions &load, unsigned int direction);
} // namespace orthocone
