// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/mesh_ladder.h>

#include <array>
#include <cmath>

namespace orthocone
{
namespace
{
/// What a level of the ladder has in the disc.
struct Level
{
  unsigned int core_cells;
  unsigned int rings;
};

constexpr std::array<Level, 6> levels{{{2, 2}, {4, 3}, {6, 4}, {8, 5}, {10, 6}, {12, 7}}};
constexpr std::array<Level, 9> axisymmetric_levels{
    {{4, 3}, {6, 4}, {10, 5}, {14, 6}, {20, 7}, {28, 8}, {40, 9}, {56, 10}, {80, 11}}};
constexpr double core_ratio = 0.6;
constexpr double rim_grading = 0.4;

/// Thickness of the thinnest of `n` intervals, each `grading` times as thick as the one before, relative to
/// all of them.
double thinnest_share(const unsigned int n, const double grading)
{
  double sum = 0;
  for (unsigned int i = 0; i < n; ++i)
    sum += std::pow(grading, i);
  return std::pow(grading, n - 1) / sum;
}

/// Grading that makes the thinnest of `n` intervals this share of all, 1 if they are thinner anyway. Rounded
/// to two digits, for people who read it.
double fitting_grading(const unsigned int n, const double share)
{
  constexpr double least = 0.05;
  constexpr double digits = 100;
  double grading = 1;
  while (grading > least && thinnest_share(n, grading) > share)
    grading -= 1 / digits;
  return std::round(digits * grading) / digits;
}

/// Sets as many layers as it takes for neighbours that do not differ by much more than the rings do.
void choose_layers(const GeometryOptions &geometry, MeshOptions &mesh)
{
  constexpr double steepest = 0.3;
  const double rim = thinnest_share(mesh.rings, mesh.rim_grading) * (1 - mesh.core_ratio) * geometry.radius;
  const double share = rim / (geometry.height / 2);
  unsigned int n_half = mesh.rings;
  while (fitting_grading(n_half, share) < steepest)
    ++n_half;
  while (n_half > 1 && 1. / (n_half - 1) <= share) // one less is thin enough without any grading
    --n_half;
  mesh.layers = 2 * n_half;
  mesh.layer_grading = fitting_grading(n_half, share);
}
} // namespace

unsigned int n_ladder_levels(const bool is_axisymmetric)
{
  return is_axisymmetric ? axisymmetric_levels.size() : levels.size();
}

MeshOptions ladder_mesh(const GeometryOptions &geometry, const MeshOptions &given, const bool is_axisymmetric,
                        const unsigned int level)
{
  MeshOptions mesh = given;
  mesh.resolution = MeshResolution::custom;
  mesh.accuracy = 0;
  const Level &chosen = is_axisymmetric ? axisymmetric_levels.at(level) : levels.at(level);
  mesh.core_cells = chosen.core_cells;
  mesh.rings = chosen.rings;
  mesh.degree = is_axisymmetric ? 4 : 3;
  mesh.core_ratio = core_ratio;
  mesh.rim_grading = rim_grading;
  choose_layers(geometry, mesh);
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
