// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

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
} // namespace orthocone::test
