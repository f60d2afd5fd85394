// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Geometry/Supports: surfaces that are held at zero in some directions, beside the held face.
#pragma once

#include <orthocone/body/options.h>
#include <orthocone/body/shapes/boundary.h>
#include <orthocone/surface/model_symmetry.h>

#include <string>
#include <vector>

namespace orthocone
{
/// A boundary of the mesh and the directions (x, y, z) in which it does not move. In a revolved section x is
/// along the radius and y around the axis.
struct HeldBoundary
{
  dealii::types::boundary_id id;
  std::array<bool, 3> directions;
};

/// What is held of a body beside planes of symmetry: its held face, and supports.
struct HeldSurfaces
{
  // Not explicit: most bodies have a held face alone.
  HeldSurfaces(const TopFace top, std::vector<HeldBoundary> at_zero = {})
      : top_face(top),
        supports(std::move(at_zero))
  {
  }

  TopFace top_face;
  std::vector<HeldBoundary> supports;
};

HeldSurfaces held_surfaces(const GeometryOptions &geometry);

/// The boundary id of a surface with this name: that of a support, or `otherwise` where it supports nothing.
dealii::types::boundary_id boundary_of_surface(const GeometryOptions &geometry, const std::string &surface,
                                               Boundary otherwise);

/// "x+" for "x-" and the like, where the mirror about this plane (0: x = 0, 1: y = 0) exchanges both surfaces
/// of a box, and the same name for all others.
std::string mirrored_surface(const std::string &surface, unsigned int plane);

/// Why the supports are not symmetric, as Shape::asymmetry(). Those of a mesh file lie on the modelled part
/// and are symmetric.
std::string asymmetry_of_supports(const GeometryOptions &geometry, const ModelSymmetry &symmetry);

/// Throws InputError where a support names a surface that the shape does not have, its contact surface, or
/// one twice. `surfaces` are the names, first the contact surface and then the held one; those of a file are
/// checked with its mesh.
void check_supports(const GeometryOptions &geometry, const std::vector<std::string> &surfaces);
} // namespace orthocone
