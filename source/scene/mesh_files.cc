// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/mesh_files.h>

#include <orthocone/base/text.h>
#include <orthocone/body/grid_surface.h>
#include <orthocone/body/shapes/imported_mesh.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/scene/body_overlap.h>
#include <orthocone/scene/contact_mesh.h>
#include <orthocone/scene/obstacle.h>

#include <algorithm>
#include <cmath>
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

/// A periodic gap goes on behind the border as it begins at the other one: from the last patches to the first
/// it changes by hardly more than it does elsewhere between neighbours.
static std::vector<std::string> period_warnings(const Parameters &parameters)
{
  constexpr double most = 2;
  const SurfaceGrid grid = surface_grid(parameters.geometry, parameters.mesh);
  const auto obstacle = make_obstacle(parameters.obstacle);
  const std::vector<SurfacePoint> points = surface_sample(parameters).points;
  const auto gap = [&](const Eigen::Index i, const Eigen::Index j)
  { return obstacle->gap(points[static_cast<std::size_t>(j % grid.n_y * grid.n_x + i % grid.n_x)]); };
  double within = 0, across = 0;
  for (Eigen::Index j = 0; j < grid.n_y; ++j)
    for (Eigen::Index i = 0; i < grid.n_x; ++i)
    {
      double &along_x = i + 1 < grid.n_x ? within : across, &along_y = j + 1 < grid.n_y ? within : across;
      along_x = std::max(along_x, std::abs(gap(i + 1, j) - gap(i, j)));
      along_y = std::max(along_y, std::abs(gap(i, j + 1) - gap(i, j)));
    }
  if (across <= most * within)
    return {};
  return {
      obstacle->entry() + ": the gap jumps by " + to_text(across) +
      " mm between opposite borders, which are one place with Geometry/Periodic = yes, and elsewhere by " +
      to_text(within) + " mm at most between patches; take a gap with the periods Sizes, or Periodic = no"};
}

std::vector<std::string> counterface_warnings(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  if (!kind_of(parameters.geometry).is_meshed() && parameters.geometry.is_periodic)
    return period_warnings(parameters);
  if (parameters.obstacle.has_normal_z())
    return {};
  if (parameters.obstacle.kind == ObstacleKind::body)
    return overlap_warnings(parameters, symmetry);
  return make_obstacle(parameters.obstacle)->warnings(surface_sample(parameters).points);
}

std::vector<std::string> scene_warnings(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  std::vector<std::string> all = mesh_file_warnings(parameters);
  for (const auto &warnings : {counterface_warnings(parameters, symmetry), layer_warnings(parameters)})
    all.insert(all.end(), warnings.begin(), warnings.end());
  return all;
}
} // namespace orthocone
