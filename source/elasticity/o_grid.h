// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/elasticity/mesh.h>

namespace orthocone
{
/// Disc of quadrilaterals around the origin, straight-sided: core block and graded rings.
void make_o_grid_disc(double radius, const MeshOptions &options, const SymmetryPlanes &planes,
                      dealii::Triangulation<2> &triangulation);

/// Half the side of the core square whose corners are `core_ratio` * `radius` off the axis.
double core_half_side(double radius, double core_ratio);

/// Positions from 0 to 1 of `n` intervals, each `grading` times as wide as the one before.
std::vector<double> graded_positions(unsigned int n, double grading);

/// Heights of the layers' faces; thickness grows or shrinks symmetrically from mid-height to both ends.
std::vector<double> layer_heights(double height, unsigned int n_layers, double grading);
} // namespace orthocone
