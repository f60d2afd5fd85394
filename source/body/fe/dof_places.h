// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/shapes/boundary.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping.h>

#include <Eigen/Dense>

#include <algorithm>
#include <vector>

namespace orthocone
{
/// A place in the body, mm; that of a section (r, z) lies in the plane y = 0.
inline Eigen::Vector3d in_space(const dealii::Point<3> &point)
{
  return {point[0], point[1], point[2]};
}
inline Eigen::Vector3d in_space(const dealii::Point<2> &point)
{
  return {point[0], 0, point[1]};
}

/// Column i: the place of degree of freedom i, mm.
template<int dim>
Eigen::Matrix3Xd positions_of(const dealii::Mapping<dim> &mapping, const dealii::DoFHandler<dim> &dof_handler)
{
  std::vector<dealii::Point<dim>> points(dof_handler.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(mapping, dof_handler, points);
  Eigen::Matrix3Xd positions(3, points.size());
  for (std::size_t dof = 0; dof < points.size(); ++dof)
    positions.col(static_cast<Eigen::Index>(dof)) = in_space(points[dof]);
  return positions;
}

/// Centroid of the held face of the whole body: of the modelled part's, but in the planes of symmetry, or on
/// the axis.
template<int dim>
Eigen::Vector3d held_centre_of(const dealii::Triangulation<dim> &triangulation)
{
  double area = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Vector3d is_inside = Eigen::Vector3d::Ones();
  double extent = 0;
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
    {
      const Eigen::Vector3d centre = in_space(face->center());
      if (face->boundary_id() == Boundary::plane_normal_to_x || face->boundary_id() == Boundary::axis)
        is_inside[0] = 0;
      if (face->boundary_id() == Boundary::plane_normal_to_y)
        is_inside[1] = 0;
      extent = std::max(extent, centre.norm());
      if (face->boundary_id() != Boundary::top_face)
        continue;
      area += face->measure();
      moment += face->measure() * centre;
    }
  if (area == 0)
    return Eigen::Vector3d::Zero();
  constexpr double rounding = 1e-12;
  const Eigen::Vector3d centre = is_inside.cwiseProduct(moment / area);
  return (centre.array().abs() < rounding * extent).select(0, centre);
}
} // namespace orthocone
