// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_accessor.h>

namespace orthocone
{
/// Manifold id of all cells, faces and lines of a mesh from a file whose edges are curved.
constexpr dealii::types::manifold_id curved_cells_manifold = 100;

/// Whether a mesh is such a one.
template<int dim>
bool has_curved_cells(const dealii::Triangulation<dim> &mesh)
{
  return mesh.n_levels() > 0 && mesh.begin(0)->manifold_id() == curved_cells_manifold;
}
} // namespace orthocone
