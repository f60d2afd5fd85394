// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>
#include <orthocone/surface/model_symmetry.h>

#include <deal.II/grid/tria.h>

namespace orthocone
{
/// Disc of quadrilaterals around the origin, straight-sided: core block and graded rings.
void make_o_grid_disc(double radius, const MeshOptions &options, const SymmetryPlanes &planes,
                      dealii::Triangulation<2> &triangulation);

/// Half the side of the core square whose corners are `core_ratio` * `radius` off the axis.
double core_half_side(double radius, double core_ratio);
} // namespace orthocone
