// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "half_space_kernel.h"

#include <vector>

namespace orthocone
{
/// The part of a contact surface that one of its places stands for, and how the place's force is spread over
/// it: evenly where the place is in the middle, else so that the place is the centre of the force. A gap and
/// a body are taken at the place, and the force must not act beside it.
struct SurfacePatch
{
  /// An edge, and the traction of a unit of force to its left, 1/mm^2.
  struct Edge
  {
    PatchEdge line;
    double density;
  };

  /// A quadrature point and its share of the force.
  struct Point
  {
    Eigen::Vector2d position;
    double share;
  };

  double area = 0;                                  ///< mm^2
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(); ///< of the force, mm
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero(); ///< mean square distance of the force from it, mm^2
  double radius = 0;                                ///< of a circle about the centre that holds the patch, mm
  std::vector<Edge> edges;                          ///< around it, or around each of its parts
  std::vector<Point> points;
  std::vector<Point> close_points; ///< twice as many per direction, for forces next to them
};

/// The patches of a whole surface, one for each of its nodes, in their order. A face is divided in both
/// directions where the Gauss-Lobatto weights of its nodes meet. So the patches tile the surface, and every
/// node lies in its own. `n_points`: HalfSpace::n_points.
std::vector<SurfacePatch> surface_patches(const ContactSurface &surface, const WholeSurface &whole,
                                          unsigned int n_points);
} // namespace orthocone
