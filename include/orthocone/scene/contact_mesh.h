// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Meshes with cells where contact is to be expected, and warnings of those that have too few there. All read
// the gap file, if there is one, and throw as make_obstacle() does.
#pragma once

#include <orthocone/scene/expected_contact.h>

namespace orthocone
{
/// How far from the axis the contact reaches, with room around it, mm; 0 where nothing is known, or where
/// cells may as well lie all over the base.
double contact_reach(const Parameters &parameters);

/// The mesh of a level of the ladder, and that of Resolution, with cells where contact is expected
/// (mesh_ladder.h).
MeshOptions ladder_mesh(const Parameters &parameters, bool is_axisymmetric, unsigned int level);
MeshOptions resolved_mesh(const Parameters &parameters, bool is_axisymmetric);

/// Warns of layers of cells that are too high below the contact to be expected: nothing, or one sentence.
std::vector<std::string> layer_warnings(const Parameters &parameters);
} // namespace orthocone
