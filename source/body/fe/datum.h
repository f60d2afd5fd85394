// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/shapes/supports.h>
#include <orthocone/surface/section_model.h>

#include <deal.II/grid/tria.h>

#include <utility>
#include <vector>

namespace orthocone
{
/// What holds a body without a held face as a rigid one, as far as supports and symmetry leave it free:
/// single displacements of vertices, which follow the motion of the components.
struct Datum
{
  std::vector<std::pair<unsigned int, unsigned int>> held; ///< numbers of vertices, and directions (x, y, z)
  std::vector<unsigned int> components;                    ///< of the rigid motion, as many
};

/// The datum of a body, on the boundary Boundary::top_face of its coarsest cells; empty where there is a held
/// face. All processes must call it, and get the same, as do the meshes that halving makes of one.
template<int dim>
Datum datum_of(const dealii::Triangulation<dim> &triangulation, const HeldSurfaces &held,
               const SectionModel &section);
} // namespace orthocone
