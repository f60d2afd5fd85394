// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/body_unknowns.h>
#include <orthocone/body/options.h>
#include <orthocone/surface/grid_half_space.h>

namespace orthocone
{
/// The patches that Geometry/Sizes, Mesh/Cells and Mesh/Refinements make on the surface of a half-space.
SurfaceGrid surface_grid(const GeometryOptions &geometry, const MeshOptions &mesh);

/// The part of the plane z = 0 on which a half-space may touch, about x = y = 0: a contact node in the middle
/// of each patch of a regular grid, whose displacement is free. There are no other unknowns. The faces of the
/// contact surface lie between the nodes, and the far field of the half-space takes the place of a held face;
/// its centre is the origin.
class GridSurface : public BodyUnknowns
{
public:
  GridSurface(const GeometryOptions &geometry, const MeshOptions &mesh);

  const SurfaceGrid &grid() const { return grid_; }

private:
  void add_nodes();
  void add_faces();

  SurfaceGrid grid_;
};
} // namespace orthocone
