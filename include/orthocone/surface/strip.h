// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/contact_surface.h>
#include <orthocone/surface/model_symmetry.h>
#include <orthocone/surface/mortar.h>

namespace orthocone
{
/// The contact surface of a model as faces: itself, or the strip between y = 0 and the thickness
/// that the lines of a plane section stand for. Each line becomes degree + 1 nodes, one behind the other, and
/// each of its faces one that is as wide as the strip.
ContactSurface as_faces(const ContactSurface &surface, const ModelSymmetry &symmetry);

/// mortar_map() of two surfaces of one model. That of a plane section says how lines see lines: displacements
/// are the same along y, so that it has the sums over the nodes of a line of the other strip, which are the
/// same for all nodes of a line.
MortarMap mortar_map(const ContactSurface &surface, const ContactSurface &other,
                     const ModelSymmetry &symmetry, Facing facing = Facing::along_z);
} // namespace orthocone
