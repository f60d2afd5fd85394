// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The scene before the run, for a picture of it (tools/scene) and for the lines of --check.
#pragma once

#include <orthocone/scene/model_choice.h>
#include <orthocone/scene/options.h>

#include <string>
#include <vector>

namespace orthocone
{
/// The values that the legs give to a component of the held face, or to a load.
struct LoadRange
{
  std::string name; ///< "uz", "Fz", or that of the load
  std::string unit;
  unsigned int number; ///< of the component, 0 to 5, or 6 + k for load k
  double least = 0, largest = 0;

  /// "-350 to 350 N", or the one value that is farthest from zero.
  std::string text() const;
};

/// The ranges of what the legs drive: motions, then forces, then loads. Motions that stay zero are left out,
/// whereas a force of zero says that the face is free to move.
std::vector<LoadRange> load_ranges(const LoadOptions &load);

/// The elastic constants in a line, "E 210000 MPa, nu 0.3", or the law of the material.
std::string material_text(const MaterialOptions &material);

/// Lines of --check and of the log on the materials, the held faces, the supports and what drives the scene.
std::string describe_materials(const Parameters &parameters);
std::string describe_held(const Parameters &parameters);
std::string describe_drive(const LoadOptions &load);

/// The scene as JSON: both bodies as faces with the names of their surfaces, contact nodes and gaps, the
/// friction law, and what drives the scene. Lengths are in mm, and the second body lies below z = 0, where it
/// is. `has_mesh` says whether the mesh of the run is known and can be made: otherwise, and where it has too
/// many faces for a picture, the faces are those of a coarse mesh, and the text says so. Throws what the
/// bodies throw.
std::string scene_description(const Parameters &parameters, const ModelChoice &model, bool has_mesh);
} // namespace orthocone
