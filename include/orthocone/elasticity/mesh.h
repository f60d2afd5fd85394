// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

#include <deal.II/grid/tria.h>

#include <string>

namespace orthocone
{
/// Planes of symmetry through the axis of the body, of which only one side is modelled: x >= 0 and y >= 0.
struct SymmetryPlanes
{
  bool normal_to_x = false; ///< the plane x = 0
  bool normal_to_y = false; ///< the plane y = 0

  /// Number of copies of the model that make the whole body.
  unsigned int n_copies() const { return (normal_to_x ? 2 : 1) * (normal_to_y ? 2 : 1); }

  /// "full", "half" or "quarter".
  std::string name() const;
};

/// Boundary ids of the body mesh.
enum Boundary : dealii::types::boundary_id
{
  contact_surface = 1,
  top_face = 2,
  lateral_surface = 3,
  plane_normal_to_x = 4,
  plane_normal_to_y = 5,
  axis = 6, ///< of a section
};

/// Cylinder of hexahedra: an o-grid disc (a square core block and four outer blocks) extruded into layers.
/// The mesh of a half or a quarter consists of exactly those cells of the full mesh that lie there. All
/// rings are curved. Half and quarter need an even number of core cells.
class BodyMesh
{
public:
  BodyMesh(const GeometryOptions &geometry, const MeshOptions &options, const SymmetryPlanes &planes);

  const dealii::Triangulation<3> &triangulation() const { return triangulation_; }

private:
  void curve_rings(double radius, double core_ratio);

  dealii::Triangulation<3> triangulation_;
};
} // namespace orthocone
