// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/mesh_ladder.h>

#include <orthocone/base/grading.h>

#include <cmath>
#include <vector>

namespace orthocone
{
namespace
{
/// A level of the ladder in the disc. The grading rises with the number of rings, so that not only the
/// outermost ring shrinks from level to level, but the widest one, too.
struct Level
{
  unsigned int core_cells;
  unsigned int rings;
  double rim_grading;
};

const std::vector<Level> &levels(const bool is_axisymmetric)
{
  static const std::vector<Level> solid{{2, 2, 0.4}, {4, 3, 0.4},   {6, 4, 0.46},
                                        {8, 5, 0.5}, {10, 7, 0.57}, {12, 9, 0.62}};
  static const std::vector<Level> section{{6, 3, 0.4},    {8, 4, 0.42},  {12, 5, 0.45},
                                          {16, 7, 0.52},  {22, 9, 0.58}, {30, 12, 0.65},
                                          {42, 17, 0.73}, {58, 25, 0.8}, {80, 36, 0.85}};
  return is_axisymmetric ? section : solid;
}

constexpr double solid_core_ratio = 0.6; // docs/accuracy.md, "How good the estimates are"
/// In a section, cells of the core cost no more than rings: the core reaches to where stick and slip meet on
/// the way up.
constexpr double section_core_ratio = 0.9;

/// Grading that makes the thinnest of `n` intervals this share of all of them; 1 if they are thinner anyway.
/// It is rounded to two digits, because people read it.
double fitting_grading(const unsigned int n, const double share)
{
  constexpr double least = 0.05;
  constexpr double digits = 100;
  double grading = 1;
  while (grading > least && thinnest_share(n, grading) > share)
    grading -= 1 / digits;
  return std::round(digits * grading) / digits;
}

/// Width of all rings together where they are narrowest: beside the corners of the core, or on the base of a
/// section.
double width_of_rings(const double radius, const double core_ratio, const bool is_axisymmetric)
{
  return radius * (is_axisymmetric ? 1 - core_ratio / std::sqrt(2.) : 1 - core_ratio);
}

/// Sets the smallest number of layers with which neighbours differ by little more than the rings do. Fields
/// vary less between base and upper face than in the disc, but layers must shrink from level to level, too.
void choose_layers(const GeometryOptions &geometry, const bool is_axisymmetric, MeshOptions &mesh)
{
  const double steepest = 0.7 * mesh.rim_grading;
  const double rim = thinnest_share(mesh.rings, mesh.rim_grading) *
                     width_of_rings(geometry.radius, mesh.core_ratio, is_axisymmetric);
  const double share = rim / (geometry.height / 2);
  unsigned int n_half = 1;
  while (n_half * share < 1 && fitting_grading(n_half, share) < steepest)
    ++n_half;
  mesh.layers = 2 * n_half;
  mesh.layer_grading = fitting_grading(n_half, share);
}
} // namespace

unsigned int n_ladder_levels(const bool is_axisymmetric)
{
  return levels(is_axisymmetric).size();
}

MeshOptions ladder_mesh(const GeometryOptions &geometry, const MeshOptions &given, const bool is_axisymmetric,
                        const unsigned int level)
{
  MeshOptions mesh = given;
  mesh.resolution = MeshResolution::custom;
  mesh.accuracy = 0;
  const Level &disc = levels(is_axisymmetric).at(level);
  mesh.core_cells = disc.core_cells;
  mesh.rings = disc.rings;
  mesh.rim_grading = disc.rim_grading;
  mesh.core_ratio = is_axisymmetric ? section_core_ratio : solid_core_ratio;
  mesh.degree = is_axisymmetric ? 4 : 3;
  choose_layers(geometry, is_axisymmetric, mesh);
  return mesh;
}

MeshOptions resolved_mesh(const GeometryOptions &geometry, const MeshOptions &given,
                          const bool is_axisymmetric)
{
  switch (given.resolution)
  {
  case MeshResolution::coarse:
    return ladder_mesh(geometry, given, is_axisymmetric, 1);
  case MeshResolution::medium:
    return ladder_mesh(geometry, given, is_axisymmetric, 2);
  case MeshResolution::fine:
    return ladder_mesh(geometry, given, is_axisymmetric, 3);
  case MeshResolution::custom:
  case MeshResolution::paper:
    break;
  }
  MeshOptions mesh = given; // whose defaults are the paper's mesh
  mesh.resolution = MeshResolution::custom;
  return mesh;
}
} // namespace orthocone
