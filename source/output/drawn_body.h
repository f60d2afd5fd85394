// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A body as faces with the names of their surfaces: what a picture of the scene needs of its mesh.
#pragma once

#include <orthocone/body/body.h>

#include <nlohmann/json.hpp>

namespace orthocone
{
using OrderedJson = nlohmann::ordered_json;

/// Entries of a body whose mesh shows its outline and no more, for pictures without the mesh of the run. Of a
/// half-space it is the box above the part that may touch.
BodyOptions with_outline_mesh(BodyOptions options);

/// {"surfaces": [{"name", "roles", "faces"}], "cells", "supports", ...}. A face is a polygon of points
/// (x, y, z) in mm, which runs anticlockwise for those who look at it from outside; of a section it is a
/// line, and "cells" are its areas. The second body is turned to lie below z = 0.
OrderedJson body_json(const Body &body, const BodyOptions &options);

/// The number of faces, or of cells of a section, that a picture of the body has.
unsigned int n_drawn(const Body &body);
} // namespace orthocone
