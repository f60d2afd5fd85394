// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>

namespace orthocone::test
{
/// Cells that are nearly cubes, so that multigrid is at its best.
inline MeshOptions even_mesh(const unsigned int degree, const unsigned int refinements)
{
  MeshOptions mesh;
  mesh.core_cells = 2;
  mesh.rings = 1;
  mesh.core_ratio = 0.6;
  mesh.layers = 2;
  mesh.degree = degree;
  mesh.refinements = refinements;
  mesh.cells = {{2, 2, 2}};
  return mesh;
}

/// Such cells of three sizes, with hanging nodes inside, on the base and in planes of symmetry.
inline MeshOptions uneven_mesh(const unsigned int degree)
{
  MeshOptions mesh = even_mesh(degree, 0);
  mesh.cells = {{4, 4, 2}};
  mesh.refined_cells = {{{0, 0}, {3, 5}}, {{2, 2}, {9, 12}, {20, 20}}};
  return mesh;
}
} // namespace orthocone::test
