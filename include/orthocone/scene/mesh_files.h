// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>
#include <orthocone/surface/model_symmetry.h>

#include <string>
#include <vector>

namespace orthocone
{
/// ImportedMesh::describe() of the bodies that come from files. The upper body is first, and lines on the
/// lower one begin with `lower`. Empty where no body is from a file. Throws as ImportedMesh does.
std::string describe_mesh_files(const Parameters &parameters);

/// ImportedMesh::warnings() of the same bodies, with the names of their own entries.
std::vector<std::string> mesh_file_warnings(const Parameters &parameters);

/// Obstacle::warnings() at the contact nodes of the scene, or overlap_warnings() of two bodies, and of a
/// periodic half-space that its gap is not periodic.
std::vector<std::string> counterface_warnings(const Parameters &parameters, const ModelSymmetry &symmetry);

/// All that is doubtful about meshes and counterface before a run: both of these, and layer_warnings().
std::vector<std::string> scene_warnings(const Parameters &parameters, const ModelSymmetry &symmetry);
} // namespace orthocone
