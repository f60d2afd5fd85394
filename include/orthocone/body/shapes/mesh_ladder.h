// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

namespace orthocone
{
/// Meshes that get finer everywhere from level to level: more cells around; rings and layers that shrink
/// geometrically towards the rim, the base and the upper face, the less so the more there are. So cells at
/// these edges get smaller by a factor on every level, and the widest in the middle get smaller, too: no
/// difference between levels would show an error that all of them have in common. Layers fit the height: the
/// lowest is as thick as the outermost ring. A section has more cells and degree 4.
MeshOptions ladder_mesh(const GeometryOptions &geometry, const MeshOptions &given, bool is_axisymmetric,
                        unsigned int level);

/// Number of levels that are meant to be solved. The finest has some 1400 contact nodes in a quarter, 300
/// rings in a section.
unsigned int n_ladder_levels(bool is_axisymmetric);

/// `given` with the entries that its resolution stands for, as Resolution = custom.
MeshOptions resolved_mesh(const GeometryOptions &geometry, const MeshOptions &given, bool is_axisymmetric);
} // namespace orthocone
