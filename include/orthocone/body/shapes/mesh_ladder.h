// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>

namespace orthocone
{
/// The mesh of a `level`, counted from 0. Meshes get finer everywhere from level to level: there are more
/// cells around, and rings and layers shrink geometrically towards the rim, the base and the upper face, by a
/// smaller factor the more there are. So cells at these edges get smaller by a factor on every level, and the
/// widest in the middle get smaller, too: no difference between levels would show an error that all of them
/// have in common. Layers fit the height: the lowest is as thick as the outermost ring. A section has more
/// cells and degree 4. Throws std::out_of_range beyond the last level.
///
/// With a `reach` (mm, from the axis) other than 0 contact is expected within it alone: the core encloses it
/// with cells of one size, and rings and layers grow from there, the less the higher the level.
MeshOptions ladder_mesh(const GeometryOptions &geometry, const MeshOptions &given, bool is_axisymmetric,
                        unsigned int level, double reach = 0);

/// Number of levels. The finest one has some 1400 contact nodes in a quarter, 300 rings in a section
/// (docs/accuracy.md, "A number").
unsigned int n_ladder_levels(bool is_axisymmetric);

/// `given` with Resolution = custom and the entries that its resolution stands for (docs/accuracy.md, "One
/// word").
MeshOptions resolved_mesh(const GeometryOptions &geometry, const MeshOptions &given, bool is_axisymmetric,
                          double reach = 0);
} // namespace orthocone
