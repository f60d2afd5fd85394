// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cmath>
#include <vector>

namespace orthocone
{
/// A plane, cylinder or sphere in which a surface of a body lies; lengths in mm.
struct SurfaceForm
{
  SurfaceKind kind;
  dealii::Point<3> centre;     ///< a point of the plane or the axis, or the centre of the sphere
  dealii::Tensor<1, 3> axis{}; ///< normal of the plane or direction of the axis, of length 1
  double radius = 0;

  /// From the centre to the point, without what does not count for the distance: |arm| is the distance from
  /// the axis, the centre, or the plane.
  dealii::Tensor<1, 3> arm(const dealii::Point<3> &point) const
  {
    const dealii::Tensor<1, 3> from = point - centre, along = (from * axis) * axis;
    return kind == SurfaceKind::sphere ? from : kind == SurfaceKind::cylinder ? from - along : along;
  }

  /// The nearest point of it; a point of the axis or the centre stays.
  dealii::Point<3> project(const dealii::Point<3> &point) const
  {
    const dealii::Tensor<1, 3> from = arm(point);
    const double distance = from.norm();
    return distance == 0 ? point : point + (radius - distance) / distance * from;
  }

  /// Normal to it at one of its points, of length 1.
  dealii::Tensor<1, 3> normal(const dealii::Point<3> &point) const
  {
    return kind == SurfaceKind::plane ? axis : arm(point) / arm(point).norm();
  }
};

/// A point in all of these forms, near the given one: it is projected onto one after the other until it
/// stays, which it does fast where they meet at an angle.
inline dealii::Point<3> projected(const std::vector<SurfaceForm> &forms, dealii::Point<3> point)
{
  constexpr unsigned int most_rounds = 200;
  constexpr double settled = 1e-16;
  for (unsigned int round = 0; round < most_rounds; ++round)
  {
    const dealii::Point<3> before = point;
    for (const SurfaceForm &form : forms)
      point = form.project(point);
    if (forms.size() == 1 || point.distance(before) <= settled * point.norm())
      break;
  }
  return point;
}

/// The same in the plane y = 0, of a section (x, z).
inline dealii::Point<2> projected(const std::vector<SurfaceForm> &forms, const dealii::Point<2> &point)
{
  const dealii::Point<3> moved = projected(forms, dealii::Point<3>(point[0], 0, point[1]));
  return {moved[0], moved[2]};
}
} // namespace orthocone
