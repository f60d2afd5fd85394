// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "local_dofs.h"

#include <orthocone/base/ranks.h>
#include <orthocone/body/shapes/boundary.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>

#include <Eigen/Dense>

#include <algorithm>
#include <functional>
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

/// Place (mm) and direction of all local degrees of freedom, by the direction of each component. Degrees
/// of freedom that no cell of this process has get neither.
struct DofPlaces
{
  Eigen::Matrix3Xd positions;
  std::vector<unsigned char> directions;
};

template<int dim>
DofPlaces places_of(const dealii::Mapping<dim> &mapping, const dealii::DoFHandler<dim> &dof_handler,
                    const dealii::Utilities::MPI::Partitioner &partitioner,
                    const std::function<unsigned int(unsigned int)> &direction_of)
{
  const auto &fe = dof_handler.get_fe();
  const auto n = partitioner.locally_owned_size() + partitioner.n_ghost_indices();
  DofPlaces places{Eigen::Matrix3Xd::Zero(3, n), std::vector<unsigned char>(n, 0)};
  const auto &scalar_fe = fe.base_element(0);
  dealii::FEValues<dim> values(mapping, scalar_fe,
                               dealii::Quadrature<dim>(scalar_fe.get_unit_support_points()),
                               dealii::update_quadrature_points);
  std::vector<dealii::types::global_dof_index> of_cell(fe.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      values.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell));
      cell->get_dof_indices(of_cell);
      for (unsigned int i = 0; i < of_cell.size(); ++i)
      {
        const auto [component, node] = fe.system_to_component_index(i);
        const unsigned int dof = partitioner.global_to_local(of_cell[i]);
        places.positions.col(dof) = in_space(values.quadrature_point(node));
        places.directions[dof] = static_cast<unsigned char>(direction_of(component));
      }
    }
  return places;
}

/// Length of an edge, or area of a quadrilateral, which may be warped: half the product of its diagonals.
inline double measure_of(const dealii::Triangulation<2>::face_iterator &face)
{
  return face->measure();
}
inline double measure_of(const dealii::Triangulation<3>::face_iterator &face)
{
  return cross_product_3d(face->vertex(3) - face->vertex(0), face->vertex(2) - face->vertex(1)).norm() / 2;
}

/// Centroid of the held face of the whole body (mm): the centroid of the modelled part, moved into the planes
/// of symmetry, or onto the axis.
template<int dim>
Eigen::Vector3d held_centre_of(const dealii::Triangulation<dim> &triangulation)
{
  double area = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Vector3d is_inside = Eigen::Vector3d::Ones();
  double extent = 0;
  const auto add = [&](const auto &face)
  {
    const Eigen::Vector3d centre = in_space(face->center());
    if (face->boundary_id() == Boundary::plane_normal_to_x || face->boundary_id() == Boundary::axis)
      is_inside[0] = 0;
    if (face->boundary_id() == Boundary::plane_normal_to_y)
      is_inside[1] = 0;
    extent = std::max(extent, centre.norm());
    if (face->boundary_id() != Boundary::top_face)
      return;
    area += measure_of(face);
    moment += measure_of(face) * centre;
  };
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          add(face);
  if (is_distributed(triangulation))
  {
    area = sum_over_ranks(area);
    sum_over_ranks(moment.data(), 3);
    extent = largest_of_ranks(extent);
    for (double &inside : is_inside)
      inside = -largest_of_ranks(-inside);
  }
  if (area == 0)
    return Eigen::Vector3d::Zero();
  constexpr double rounding = 1e-12;
  const Eigen::Vector3d centre = is_inside.cwiseProduct(moment / area);
  return (centre.array().abs() < rounding * extent).select(0, centre);
}
} // namespace orthocone
