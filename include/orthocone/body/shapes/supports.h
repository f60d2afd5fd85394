// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Surfaces beside the contact surface and the held face that count: Geometry/Supports, which are held at zero
// in some directions, and those on which loads act.
#pragma once

#include <orthocone/body/options.h>
#include <orthocone/body/shapes/boundary.h>
#include <orthocone/surface/model_symmetry.h>

#include <string>
#include <vector>

namespace orthocone
{
/// A boundary of the mesh and the directions (x, y, z) in which it does not move by itself. In a revolved
/// section x is along the radius and y around the axis.
struct HeldBoundary
{
  dealii::types::boundary_id id;
  std::array<bool, 3> directions;
};

/// What is held of a body beside planes of symmetry: its held face, supports, and surfaces that loads move.
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
  bool contact_faces_down = true; ///< GeometryOptions::faces_down
  bool has_datum =
      false; ///< whether contact may hold what nothing else does: of the upper body with a free top
};

HeldSurfaces held_surfaces(const GeometryOptions &geometry);

/// The names of all surfaces of supports and of loads on this body, each once, in the order of their boundary
/// ids from Boundary::first_support on.
std::vector<std::string> marked_surfaces(const GeometryOptions &geometry);

/// The boundary id of one of these.
dealii::types::boundary_id boundary_of_marked(const GeometryOptions &geometry, const std::string &surface);

/// The boundary id of a surface with this name, or `otherwise` where it has neither supports nor loads.
dealii::types::boundary_id boundary_of_surface(const GeometryOptions &geometry, const std::string &surface,
                                               Boundary otherwise);

/// "x+" for "x-" and the like, where the mirror about this plane (0: x = 0, 1: y = 0) exchanges both surfaces
/// of a box, and the same name for all others.
std::string mirrored_surface(const std::string &surface, unsigned int plane);

/// Why supports or loads are not symmetric, as Shape::asymmetry(). Surfaces of a mesh file lie on the
/// modelled part and are symmetric.
std::string asymmetry_of_surfaces(const GeometryOptions &geometry, const ModelSymmetry &symmetry);

/// Throws InputError where Contact surface names what the shape does not have, what is held, or what does not
/// face the counterface. `surfaces` are the names, first the base and then the held one; those of a file are
/// checked with its mesh.
void check_contact_surfaces(const GeometryOptions &geometry, const std::vector<std::string> &surfaces);

/// Throws InputError where a support names a surface that the shape does not have, its contact surface, or
/// one twice. `surfaces` are as for check_contact_surfaces().
void check_supports(const GeometryOptions &geometry, const std::vector<std::string> &surfaces);

/// The same of the surfaces on which loads act.
void check_surfaces_of_loads(const GeometryOptions &geometry, const std::vector<std::string> &surfaces);
} // namespace orthocone
