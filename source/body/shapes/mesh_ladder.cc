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

  /// Cells along a side of a core about a small contact, which no symmetry divides in the middle of a cell.
  unsigned int contact_cells() const { return core_cells + 2; }
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

/// Sets the smallest number of layers whose outermost ones have this share of half the height, and differ by
/// no more than the factor `steepest` from their neighbours.
void set_layers(const double share, const double steepest, MeshOptions &mesh)
{
  unsigned int n_half = 1;
  while (n_half * share < 1 && fitting_grading(n_half, share) < steepest)
    ++n_half;
  mesh.layers = 2 * n_half;
  mesh.layer_grading = fitting_grading(n_half, share);
}

/// Core and rings about a contact that reaches so far (mm) from the axis: see ladder_mesh().
void enclose_contact(const GeometryOptions &geometry, const Level &level, const double reach,
                     MeshOptions &mesh)
{
  constexpr double most_rings = 200;
  constexpr double digits = 1e3;
  const double corners = std::ceil(digits * std::sqrt(2.) * reach / geometry.radius) / digits;
  mesh.core_ratio = std::max(0.01, corners);
  mesh.core_cells = level.contact_cells();
  const double half_side = mesh.core_ratio * geometry.radius / std::sqrt(2.);
  const double cell = 2 * half_side / mesh.core_cells;
  const double share = cell / (geometry.radius - half_side);
  mesh.rings = 1;
  while (mesh.rings < most_rings && fitting_grading(mesh.rings, share) < level.rim_grading)
    ++mesh.rings;
  mesh.rim_grading = std::round(100 / fitting_grading(mesh.rings, share)) / 100;
  set_layers(cell / (geometry.height / 2), level.rim_grading, mesh);
}

/// Sets the smallest number of layers with which neighbours differ by little more than the rings do. Fields
/// vary less between base and upper face than in the disc, but layers must shrink from level to level, too.
void choose_layers(const GeometryOptions &geometry, const bool is_axisymmetric, MeshOptions &mesh)
{
  const double steepest = 0.7 * mesh.rim_grading;
  const double rim = thinnest_share(mesh.rings, mesh.rim_grading) *
                     width_of_rings(geometry.radius, mesh.core_ratio, is_axisymmetric);
  set_layers(rim / (geometry.height / 2), steepest, mesh);
}
} // namespace

unsigned int n_ladder_levels(const bool is_axisymmetric)
{
  return levels(is_axisymmetric).size();
}

MeshOptions ladder_mesh(const GeometryOptions &geometry, const MeshOptions &given, const bool is_axisymmetric,
                        const unsigned int level, const double reach)
{
  MeshOptions mesh = given;
  mesh.resolution = MeshResolution::custom;
  mesh.accuracy = 0;
  mesh.accuracy_of = all_quantities;
  const Level &disc = levels(is_axisymmetric).at(level);
  mesh.degree = is_axisymmetric ? 4 : 3;
  if (reach > 0)
  {
    enclose_contact(geometry, disc, reach, mesh);
    return mesh;
  }
  mesh.core_cells = disc.core_cells;
  mesh.rings = disc.rings;
  mesh.rim_grading = disc.rim_grading;
  mesh.core_ratio = is_axisymmetric ? section_core_ratio : solid_core_ratio;
  choose_layers(geometry, is_axisymmetric, mesh);
  return mesh;
}

MeshOptions resolved_mesh(const GeometryOptions &geometry, const MeshOptions &given,
                          const bool is_axisymmetric, const double reach)
{
  switch (given.resolution)
  {
  case MeshResolution::coarse:
    return ladder_mesh(geometry, given, is_axisymmetric, 1, reach);
  case MeshResolution::medium:
    return ladder_mesh(geometry, given, is_axisymmetric, 2, reach);
  case MeshResolution::fine:
    return ladder_mesh(geometry, given, is_axisymmetric, 3, reach);
  case MeshResolution::custom:
  case MeshResolution::paper:
    break;
  }
  MeshOptions mesh = given; // whose defaults are the paper's mesh
  mesh.resolution = MeshResolution::custom;
  return mesh;
}
} // namespace orthocone
