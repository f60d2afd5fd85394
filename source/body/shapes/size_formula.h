// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/shapes/shape.h>

#include <array>

namespace orthocone
{
/// Numbers of the modelled base: quadrilaterals, edges around it, and edges on each plane of symmetry, 0 for
/// none.
struct BaseSize
{
  double faces;
  double boundary_edges;
  std::array<double, 2> plane_edges;
};

/// Size of a model of hexahedra in layers above the base.
ModelSize solid_size(const BaseSize &base, unsigned int layers, unsigned int degree, TopFace top_face);

/// Size of a section with so many cells along its base. `symmetry` is that of a section.
ModelSize section_size(double base_cells, unsigned int layers, unsigned int degree, TopFace top_face,
                       const ModelSymmetry &symmetry);
} // namespace orthocone
