// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/grid/cell_id.h>

#include <cstdint>
#include <vector>

namespace orthocone
{
/// Identifies a cell by its number in the unhalved mesh and by the halvings behind it. This is the same in
/// meshes of one process and of several; deal.II's identifiers count the trees of p4est where cells are
/// shared.
template<typename Cell>
dealii::CellId common_id(const Cell &cell)
{
  const dealii::CellId id = cell->id();
  const auto children = id.get_child_indices();
  auto ancestor = cell->level() == 0 ? static_cast<int>(cell->index()) : 0;
  if (cell->level() > 0)
  {
    auto parent = cell->parent();
    while (parent->level() > 0)
      parent = parent->parent();
    ancestor = parent->index();
  }
  return dealii::CellId(static_cast<dealii::types::coarse_cell_id>(ancestor),
                        std::vector<std::uint8_t>(children.begin(), children.end()));
}
} // namespace orthocone
