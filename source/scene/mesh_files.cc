// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/mesh_files.h>

#include <orthocone/body/shapes/imported_mesh.h>
#include <orthocone/scene/body_overlap.h>
#include <orthocone/scene/obstacle.h>

#include <sstream>

namespace orthocone
{
namespace
{
bool has_lower_file(const Parameters &parameters)
{
  return parameters.obstacle.kind == ObstacleKind::body && parameters.lower.geometry.is_from_file();
}
} // namespace

std::string describe_mesh_files(const Parameters &parameters)
{
  std::string text = parameters.geometry.is_from_file() ? ImportedMesh(parameters.geometry).describe() : "";
  if (!has_lower_file(parameters))
    return text;
  std::istringstream of_lower(ImportedMesh(parameters.lower.geometry).describe());
  for (std::string line; std::getline(of_lower, line);)
    text += "lower " + line + "\n";
  return text;
}

std::vector<std::string> mesh_file_warnings(const Parameters &parameters)
{
  std::vector<std::string> warnings;
  if (parameters.geometry.is_from_file())
    warnings = ImportedMesh(parameters.geometry).warnings(parameters.mesh);
  if (has_lower_file(parameters))
    for (std::string &warning : ImportedMesh(parameters.lower.geometry).warnings(parameters.lower.mesh))
      warnings.push_back(std::move(warning));
  return warnings;
}

std::vector<std::string> counterface_warnings(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (parameters.obstacle.has_normal_z())
    return {};
  if (parameters.obstacle.kind == ObstacleKind::body)
    return overlap_warnings(parameters, symmetry);
  return make_obstacle(parameters.obstacle)->warnings(surface_sample(parameters).points);
}
} // namespace orthocone
