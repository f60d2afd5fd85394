// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>
#include <orthocone/surface/contact_surface.h>
#include <orthocone/surface/model_symmetry.h>

#include <Eigen/Dense>

#include <string>
#include <vector>

namespace orthocone
{
/// Places where what depends on x and y is looked at before there is a model: the contact nodes of the whole
/// body.
struct SurfaceSample
{
  std::vector<Eigen::Vector2d> places; ///< of the whole contact surface, mm
  std::vector<Eigen::Vector2d>
      radii;                     ///< (r, 0) of the rings of a section, mm; none where there is no section
  std::vector<double> heights{}; ///< of the places above z = 0, mm; none: all 0
  Eigen::Vector3d held_centre = Eigen::Vector3d::Zero(); ///< of the whole held face, mm

  /// The places of a model that its maps are applied to.
  const std::vector<Eigen::Vector2d> &of(const ModelSymmetry &symmetry) const
  {
    return symmetry.is_axisymmetric() ? radii : places;
  }
};

/// Whether gap or friction depend on the place.
inline bool varies_over_surface(const Parameters &parameters)
{
  return parameters.friction.varies() || !parameters.obstacle.is_plane();
}

/// Where contact nodes lie, mm.
std::vector<Eigen::Vector2d> places_of(const ContactSurface &surface);

/// The contact nodes that the parameters give without single cells that are halved; of a mesh file all of
/// them and their images; those of the finest mesh
/// of the ladder if a search is to choose it. The nodes of the run are checked when there is a model (Scene).
SurfaceSample surface_sample(const Parameters &parameters);

/// Orthogonal maps of the plane that leave a symmetric scene as it is: mirrors, or turns about the axis and
/// the mirror of the section's own plane.
std::vector<Eigen::Matrix2d> symmetry_maps(const ModelSymmetry &symmetry);

/// A value as messages print it: a number, "not a number" or "infinite".
std::string value_text(double value);

/// "(3, 4) mm", with four digits.
std::string place_text(const Eigen::Vector2d &place);
} // namespace orthocone
