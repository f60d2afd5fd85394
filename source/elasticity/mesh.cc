// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/elasticity/mesh.h>

#include "o_grid.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>

namespace orthocone
{
namespace
{
constexpr dealii::types::manifold_id rim_manifold = 1;

/// Heights of the layers' faces; thickness grows or shrinks symmetrically from mid-height to both ends.
std::vector<double> layer_heights(const double height, const unsigned int n_layers, const double grading)
{
  std::vector<double> z{0};
  for (unsigned int layer = 0; layer < n_layers; ++layer)
    z.push_back(z.back() + std::pow(grading, std::abs(layer - 0.5 * (n_layers - 1))));
  for (double &position : z)
    position *= height / z[n_layers];
  z.back() = height;
  return z;
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
    {
      face->set_boundary_id(boundary_of(face, geometry, planes));
      // With its edges: set_all_manifold_ids_on_boundary() would pass over those, whose boundary ids are not
      // set.
      if (face->boundary_id() == Boundary::lateral_surface)
        face->set_all_manifold_ids(rim_manifold);
    }
  triangulation_.set_manifold(rim_manifold, dealii::CylindricalManifold<3>(2));
}
} // namespace orthocone
