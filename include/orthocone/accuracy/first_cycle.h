// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The march through the first cycle, on which searches for a mesh or for the size of load steps rely.
#pragma once

#include <orthocone/accuracy/accuracy.h>
#include <orthocone/march/march.h>

namespace orthocone
{
/// The load program up to the end of the first cycle.
LoadOptions first_cycle(LoadOptions load);

/// The results of a march through the first cycle.
struct FirstCycle
{
  Quantities quantities{};
  double motion = 0; ///< largest of the top along z, whatever drives it, mm
};

/// Marches through the first cycle of `load` in a scene, with its `solver`; `also` watches accepted steps.
/// Throws std::runtime_error if a step is not solved; the message names `entry`, which asked for the march.
FirstCycle march_first_cycle(const Scene &scene, const LoadOptions &load, StepSolver &solver,
                             const char *entry, MarchObserver &also);
FirstCycle march_first_cycle(const Scene &scene, const LoadOptions &load, StepSolver &solver,
                             const char *entry);

/// Area of the contact surface of the model, mm^2.
double contact_area(const Scene &scene);
} // namespace orthocone
