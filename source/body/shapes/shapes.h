// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/shapes/shape.h>

namespace orthocone
{
/// Hexahedra: an o-grid disc (a square core block and four outer blocks) extruded into layers. All rings are
/// curved. Half and quarter need an even number of core cells. The section has the cells that the o-grid has
/// along the x axis, in the same layers. Of an odd number of core cells, half of the one on the axis is a
/// whole cell there.
std::unique_ptr<Shape> make_cylinder(const GeometryOptions &geometry, const MeshOptions &mesh);

/// Box centred on the z axis, of bricks graded towards the side faces, the base and the held face. A model
/// that ends at x = 0 or y = 0 needs an even number of cells along that axis.
std::unique_ptr<Shape> make_box(const GeometryOptions &geometry, const MeshOptions &mesh);

/// The cells of a mesh file. There is no other model than the part of the body that the file has.
std::unique_ptr<Shape> make_file_shape(const GeometryOptions &geometry, const MeshOptions &mesh);
} // namespace orthocone
