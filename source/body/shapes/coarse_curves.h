// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "curved_cell.h"

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace orthocone
{
/// What is curved of an unrefined mesh (mm): the middles of its lines, quadrilaterals and hexahedra, by their
/// vertices, whose numbers are sorted, and the surfaces in which lines and faces lie exactly.
template<int dim>
struct CoarseCurves
{
  template<std::size_t n>
  using Key = std::array<unsigned int, n>;

  std::map<Key<2>, dealii::Point<dim>> of_lines;
  std::map<Key<4>, dealii::Point<dim>> of_quads;
  std::map<Key<8>, dealii::Point<dim>> of_hexes;
  std::map<Key<2>, std::vector<SurfaceForm>> forms_of_lines;
  std::map<Key<4>, SurfaceForm> forms_of_quads;

  /// Whether all edges are straight.
  bool is_empty() const { return of_lines.empty(); }
};

using CoarseCell2 = dealii::Triangulation<2>::cell_iterator;
using CoarseCell3 = dealii::Triangulation<3>::cell_iterator;

/// The sorted numbers of the vertices of a line, a quadrilateral or a hexahedron.
template<std::size_t n, typename Object>
std::array<unsigned int, n> key_of(const Object &object)
{
  std::array<unsigned int, n> key{};
  for (unsigned int v = 0; v < n; ++v)
    key[v] = object->vertex_index(v);
  std::sort(key.begin(), key.end());
  return key;
}

/// Adds the middles that are missing: those of lines are on their chords, and those of quadrilaterals and
/// hexahedra follow from the lines around, as in elements of 8 and 20 nodes. Those of lines and faces with
/// forms are moved onto these.
void complete(CoarseCurves<3> &curves, const dealii::Triangulation<3> &mesh);

/// The map of a coarse cell.
template<int dim>
CurvedCell<dim> curved_cell(const CoarseCurves<dim> &curves,
                            const typename dealii::Triangulation<dim>::cell_iterator &cell);

/// Makes the mesh, which must be unrefined, follow the curves wherever cells are halved and mapped: all of
/// its cells, faces and lines get one manifold of that kind.
template<int dim>
void attach(const CoarseCurves<dim> &curves, dealii::Triangulation<dim> &mesh);

/// The curves of the plane y = 0 of a layer of cells, for its section (x, z). `numbers` are those of the
/// section's vertices by the layer's.
CoarseCurves<2> flattened(const CoarseCurves<3> &layer, const std::map<unsigned int, unsigned int> &numbers);
} // namespace orthocone
