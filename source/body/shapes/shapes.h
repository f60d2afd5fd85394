// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/shapes/shape_kind.h>

namespace orthocone
{
/// The sentence of Shape::asymmetry() on a section of a body that is none of revolution.
std::string no_body_of_revolution(const GeometryOptions &geometry);

/// A cylinder of hexahedra: an o-grid disc (a square core block and four outer blocks) extruded into layers.
/// All rings are curved. Half and quarter need an even number of core cells. The section has the cells of the
/// o-grid along the x axis, in the same layers. If the number of core cells is odd, half of the cell on the
/// axis is a whole cell there.
const ShapeKind &cylinder_kind();

/// A box centred on the z axis, of bricks graded towards the side faces, the base and the held face. A model
/// that ends at x = 0 or y = 0 needs an even number of cells along that axis.
const ShapeKind &box_kind();

/// A half-space on a regular grid, without a mesh. It has the entries of a box, without the third numbers.
const ShapeKind &half_space_kind();

/// The cells of a mesh file. The part of the body in the file is the only model.
const ShapeKind &file_kind();
} // namespace orthocone
