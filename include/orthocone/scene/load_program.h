// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/load_steps.h>
#include <orthocone/scene/options.h>

#include <string>
#include <vector>

namespace orthocone
{
/// What the held face does: the legs of the preload and of all cycles, and what follows from them.
class LoadProgram
{
public:
  explicit LoadProgram(LoadOptions load);

  /// All steps, in order. Cycles repeat the same positions to the last bit.
  LoadSteps steps() const;

  std::size_t n_steps() const;

  /// The number of steps of the legs that are repeated.
  std::size_t n_steps_of_cycle() const;

  /// The number of problems that the steps need: a step in parts counts as many as its parts.
  double n_solved_parts() const;

  /// The preload and one cycle, which all cycles are like.
  LoadProgram first_cycle() const;

  /// Largest |u| (mm) over the corners of the program in a direction (0: x, 1: y, 2: z), where motions drive
  /// it.
  double largest_motion(unsigned int direction) const;

  /// The largest of the three directions, mm.
  double largest_motion() const;

  /// Whether a leg moves or loads a component (0 to 5) away from zero.
  bool drives(unsigned int component) const;

  /// Whether a force drives a component in some leg.
  bool is_driven_by_force(unsigned int component) const;

  /// Whether a force drives any component.
  bool has_forces() const;

  /// Why the program does not have the symmetry of a model; empty if it has.
  std::string asymmetry(const ModelSymmetry &symmetry) const;

private:
  LoadOptions load_;
};
} // namespace orthocone
