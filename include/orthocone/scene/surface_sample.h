// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>
#include <orthocone/surface/contact_surface.h>
#include <orthocone/surface/model_symmetry.h>

#include <Eigen/Dense>

#include <string>
#include <vector>

namespace orthocone
{
/// A place of the contact surface (mm), and the normal of the body there, of length 1 and into the body.
struct SurfacePoint
{
  Eigen::Vector3d place;
  Eigen::Vector3d inward = Eigen::Vector3d::UnitZ();

  Eigen::Vector2d in_plane() const { return place.head<2>(); } ///< (x, y)

  /// Its image under a congruent map of the plane z = 0.
  SurfacePoint mapped(const Eigen::Affine2d &map) const
  {
    SurfacePoint image = *this;
    image.place.head<2>() = map * place.head<2>();
    image.inward.head<2>() = map.linear() * inward.head<2>();
    return image;
  }
};

/// The points where fields of x, y and z are evaluated before there is a model: the contact nodes of the
/// whole body.
struct SurfaceSample
{
  std::vector<SurfacePoint> points; ///< of the whole contact surface
  std::vector<SurfacePoint> rings;  ///< of a revolved section, at y = 0; none where there is no such section
  Eigen::Vector3d held_centre = Eigen::Vector3d::Zero(); ///< of the whole held face, mm

  /// The points to which the maps of a model are applied.
  const std::vector<SurfacePoint> &of(const ModelSymmetry &symmetry) const
  {
    return symmetry.is_axisymmetric() ? rings : points;
  }
};

/// Whether gap or friction depend on the place.
inline bool varies_over_surface(const Parameters &parameters)
{
  return parameters.friction.varies() || !parameters.obstacle.is_plane();
}

/// The section model of a scene in plane strain, with the thickness of its geometry.
ModelSymmetry plane_strain(const Parameters &parameters, bool has_third, bool is_mirrored_about_x = false);

/// The points of contact nodes.
std::vector<SurfacePoint> points_of(const ContactSurface &surface);

/// The contact nodes of the mesh that the parameters give, without cells that are halved singly; for a mesh
/// file all its nodes and their images; for a mesh that a search chooses, the nodes of the finest mesh of the
/// ladder. The nodes of the run itself are checked when there is a model (Scene). Throws what the mesh
/// throws.
SurfaceSample surface_sample(const Parameters &parameters);

/// Congruent maps of the plane that leave a symmetric scene as it is: mirrors; turns about the axis, or
/// shifts along y, and the mirror of the section's own plane where the section has no third component.
std::vector<Eigen::Affine2d> symmetry_maps(const ModelSymmetry &symmetry);

/// A value as messages print it: a number, "not a number" or "infinite".
std::string value_text(double value);

/// "(3, 4) mm", with four digits, or "(3, 4, 5) mm" where z is not 0.
std::string place_text(const Eigen::Vector2d &place);
std::string place_text(const Eigen::Vector3d &place);
} // namespace orthocone
