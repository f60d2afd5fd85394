// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/elasticity/mesh.h>

#include "o_grid.h"
#include "ring_manifold.h"

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
constexpr unsigned int n_ring_blocks = 4;
constexpr dealii::types::manifold_id first_ring_manifold = 1;

/// Quarter turns from the positive x axis to the outer block in which a cell lies, or n_ring_blocks for the
/// core.
unsigned int block_of(const dealii::Point<3> &centre, const double half_side)
{
  const double x = centre[0];
  const double y = centre[1];
  if (std::max(std::abs(x), std::abs(y)) < half_side)
    return n_ring_blocks;
  if (std::abs(x) > std::abs(y))
    return x > 0 ? 0 : 2;
  return y > 0 ? 1 : 3;
}

bool lies_in_plane(const dealii::Triangulation<3>::face_iterator &face, const unsigned int axis,
                   const double value, const double tolerance)
{
  for (const unsigned int vertex : face->vertex_indices())
    if (std::abs(face->vertex(vertex)[axis] - value) > tolerance)
      return false;
  return true;
}

Boundary boundary_of(const dealii::Triangulation<3>::face_iterator &face, const GeometryOptions &geometry,
                     const SymmetryPlanes &planes)
{
  constexpr double relative_tolerance = 1e-12;
  const double z_tolerance = relative_tolerance * geometry.height;
  const double r_tolerance = relative_tolerance * geometry.radius;
  if (lies_in_plane(face, 2, 0, z_tolerance))
    return Boundary::contact_surface;
  if (lies_in_plane(face, 2, geometry.height, z_tolerance))
    return Boundary::top_face;
  if (planes.normal_to_x && lies_in_plane(face, 0, 0, r_tolerance))
    return Boundary::plane_normal_to_x;
  if (planes.normal_to_y && lies_in_plane(face, 1, 0, r_tolerance))
    return Boundary::plane_normal_to_y;
  return Boundary::lateral_surface;
}
} // namespace

std::string SymmetryPlanes::name() const
{
  const unsigned int n = n_copies();
  return n == 1 ? "full" : n == 2 ? "half" : "quarter";
}

BodyMesh::BodyMesh(const GeometryOptions &geometry, const MeshOptions &options, const SymmetryPlanes &planes)
{
  dealii::Triangulation<2> disc;
  make_o_grid_disc(geometry.radius, options, planes, disc);
  dealii::GridGenerator::extrude_triangulation(
      disc, layer_heights(geometry.height, options.layers, options.layer_grading), triangulation_);
  for (const auto &face : triangulation_.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(boundary_of(face, geometry, planes));
  curve_rings(geometry.radius, options.core_ratio);
}

void BodyMesh::curve_rings(const double radius, const double core_ratio)
{
  const double half_side = core_half_side(radius, core_ratio);
  for (const auto &cell : triangulation_.active_cell_iterators())
    if (const unsigned int block = block_of(cell->center(), half_side); block < n_ring_blocks)
      cell->set_all_manifold_ids(first_ring_manifold + block);
  for (unsigned int block = 0; block < n_ring_blocks; ++block)
    triangulation_.set_manifold(first_ring_manifold + block, RingManifold(radius, half_side, block));
}
} // namespace orthocone
