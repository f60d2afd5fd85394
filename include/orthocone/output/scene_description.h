// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The scene before the run, for a picture of it (tools/scene).
#pragma once

#include <orthocone/scene/model_choice.h>
#include <orthocone/scene/options.h>

#include <string>

namespace orthocone
{
/// The scene as JSON: both bodies as faces with the names of their surfaces, contact nodes and gaps, the
/// friction law, and what drives the scene. Lengths are in mm, and the second body lies below z = 0, where it
/// is. `has_mesh` says whether the mesh of the run is known and can be made: otherwise, and where it has too
/// many faces for a picture, the faces are those of a coarse mesh, and the text says so. Throws what the
/// bodies throw.
std::string scene_description(const Parameters &parameters, const ModelChoice &model, bool has_mesh);
} // namespace orthocone
