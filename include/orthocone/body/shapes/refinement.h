// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace orthocone
{
/// Halves cells of a mesh in every direction as the options say: all of them, then those of each round, which
/// are numbered as the active cells in the mesh's order. Then cells that were halved are made one size
/// larger, as often as the options say, where their neighbours allow it. Throws InputError for a number that
/// no cell has, TooLargeError for millions of cells.
template<int dim>
void refine(dealii::Triangulation<dim> &triangulation, const MeshOptions &options);

/// The same for cells that several processes share. `whole` is the unrefined mesh. Where single cells are
/// halved every process refines it for itself, because the numbers of cells belong to one whole mesh.
void refine_shared(dealii::Triangulation<3> &shared, dealii::Triangulation<3> &whole,
                   const MeshOptions &options);

/// For each active cell, in their order, its number in `whole`, the mesh of one process. Cells of other
/// processes get no number of a cell.
std::vector<unsigned int> numbers_in_whole(const dealii::Triangulation<3> &shared,
                                           const dealii::Triangulation<3> &whole);
} // namespace orthocone
