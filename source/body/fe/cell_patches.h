// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>

#include <set>
#include <utility>
#include <vector>

namespace orthocone
{
/// A cell of a patch, or its image in planes of symmetry: bit 0 mirrors x, bit 1 y. Both together turn a
/// section by half a turn about its axis.
template<int dim>
struct PatchCell
{
  typename DisplacementSpace<dim>::Cell cell;
  unsigned int images;

  /// -1 where the image has the other sign along direction d (x, y, z), else 1.
  double sign(const unsigned int d) const { return (images >> d & 1) != 0 ? -1 : 1; }
};

/// The cells around the vertices of a mesh. A patch of an inner vertex has the cells that meet there. At a
/// surface, and between materials, it has their neighbours, too, so that at least two layers of cells tell
/// how a field changes with the depth. It never has two materials, because stress jumps between them. At
/// planes of symmetry and at the axis it has the images of its cells, so that the patches of a quarter of a
/// body are those of the whole.
template<int dim>
class CellPatches
{
public:
  using Cell = typename DisplacementSpace<dim>::Cell;

  /// `space` must outlive this object, and belong to one process.
  explicit CellPatches(const DisplacementSpace<dim> &space);

  /// The patch of a vertex for the cells of one material, in the order of the cells.
  std::vector<PatchCell<dim>> around(unsigned int vertex, dealii::types::material_id material) const;

  /// The cells that meet at a vertex.
  const std::vector<Cell> &cells_at(const unsigned int vertex) const { return cells_[vertex]; }

private:
  using Members = std::set<std::pair<Cell, unsigned int>>;
  void add_neighbours(const Cell &cell, unsigned int images, Members &members) const;

  std::vector<std::vector<Cell>> cells_;       ///< of each vertex
  std::vector<std::set<unsigned int>> images_; ///< of each vertex, those of the planes on which it lies
  std::vector<bool> is_on_surface_;            ///< of each vertex
};
} // namespace orthocone
