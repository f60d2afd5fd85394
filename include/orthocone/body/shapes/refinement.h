// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace orthocone
{
/// Halves the cells of a mesh in every direction as the options say: all of them, then those of each round,
/// which have the numbers of the active cells in the mesh's order. Then cells
/// that were halved are made one size larger, as often as the options say, where their neighbours allow it.
/// Throws InputError for a number that no cell has, TooLargeError for millions of cells.
template<int dim>
void refine(dealii::Triangulation<dim> &triangulation, const MeshOptions &options);

/// The same with the cells that several processes share. `whole`: the unrefined mesh, which every process
/// refines for itself where single cells are halved: their numbers are those of one mesh.
void refine_shared(dealii::Triangulation<3> &shared, dealii::Triangulation<3> &whole,
                   const MeshOptions &options);

/// Of every cell that this process has its number in `whole`, the mesh of one process, in the order of the
/// active cells; of the others no number of a cell.
std::vector<unsigned int> numbers_in_whole(const dealii::Triangulation<3> &shared,
                                           const dealii::Triangulation<3> &whole);
} // namespace orthocone
