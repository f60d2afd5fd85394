// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>
#include <orthocone/surface/model_symmetry.h>

#include <deal.II/grid/tria.h>

namespace orthocone
{
/// Disc of straight-sided quadrilaterals around the origin: a core block and graded rings, mm.
void make_o_grid_disc(double radius, const MeshOptions &options, const SymmetryPlanes &planes,
                      dealii::Triangulation<2> &triangulation);

/// Half the side (mm) of the core square, whose corners are at the distance `core_ratio` * `radius` from the
/// axis.
double core_half_side(double radius, double core_ratio);
} // namespace orthocone
