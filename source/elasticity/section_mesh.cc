// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "o_grid.h"

#include <orthocone/elasticity/axisymmetric_body.h>

#include <deal.II/grid/grid_generator.h>

namespace orthocone
{
namespace
{
std::vector<double> radii(const double radius, const MeshOptions &options)
{
  const unsigned int n_core = (options.core_cells + 1) / 2;
  const double core = core_half_side(radius, options.core_ratio);
  std::vector<double> positions;
  for (unsigned int i = 0; i < n_core; ++i)
    positions.push_back(core * i / n_core);
  for (const double depth : graded_positions(options.n_rings(), options.rim_grading))
    positions.push_back(core + depth * (radius - core));
  positions.back() = radius;
  return positions;
}

std::vector<double> differences(const std::vector<double> &positions)
{
  std::vector<double> steps;
  for (std::size_t i = 1; i < positions.size(); ++i)
    steps.push_back(positions[i] - positions[i - 1]);
  return steps;
}

/// The boundaries of a coloured rectangle: left, right, lower, upper.
constexpr std::array<Boundary, 4> boundaries{
    {Boundary::axis, Boundary::lateral_surface, Boundary::contact_surface, Boundary::top_face}};
} // namespace

SectionMesh::SectionMesh(const GeometryOptions &geometry, const MeshOptions &options)
{
  constexpr bool colourize = true;
  dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation_,
      {differences(radii(geometry.radius, options)),
       differences(layer_heights(geometry.height, options.layers, options.layer_grading))},
      dealii::Point<2>(0, 0), dealii::Point<2>(geometry.radius, geometry.height), colourize);
  for (const auto &face : triangulation_.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(boundaries[face->boundary_id()]);
}
} // namespace orthocone
