// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/parameters.h>

#include <string>
#include <vector>

namespace orthocone
{
/// The entry of the height of the body, as messages name it.
std::string height_entry(const GeometryOptions &geometry);

/// Throws InputError for entries that would choose the mesh of another shape.
void check_mesh_choice_of_shape(const Parameters &parameters);

/// Throws InputError unless the Gauss points give every deformation of a cell a stiffness.
void check_quadrature(const MeshOptions &mesh);

/// Checks conditions between entries that depend on the shape: gradings, probes. Throws InputError.
void check_shape(const Parameters &parameters);

/// Whether the rim of the lower body touches the upper one, whose base is no smaller.
bool rim_of_lower_body_touches(const Parameters &parameters);

/// Warns where an entry belongs to another shape.
void warn_of_shape(const Parameters &parameters, std::vector<std::string> &warnings);
} // namespace orthocone
