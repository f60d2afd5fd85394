// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

#include <deal.II/grid/tria.h>

namespace orthocone
{
/// Halves the cells of a mesh in every direction as the options say: all of them, then those of each round,
/// which have the numbers of the active cells in the mesh's order. Then the smallest cells of all are made
/// coarser again as often as the options say. Throws InputError for a number that no cell has.
template<int dim>
void refine(dealii::Triangulation<dim> &triangulation, const MeshOptions &options);
} // namespace orthocone
