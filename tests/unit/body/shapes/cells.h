// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/shapes/body_mesh.h>

#include <array>
#include <set>

namespace orthocone::test
{
/// A cell by its vertices.
using CellKey = std::set<std::array<double, 3>>;

inline std::set<CellKey> cells_of(const BodyMesh &mesh)
{
  std::set<CellKey> cells;
  for (const auto &cell : mesh.triangulation().active_cell_iterators())
  {
    CellKey key;
    for (const unsigned int vertex : cell->vertex_indices())
    {
      const auto &x = cell->vertex(vertex);
      key.insert(std::array<double, 3>{{x[0], x[1], x[2]}});
    }
    cells.insert(key);
  }
  return cells;
}
} // namespace orthocone::test
