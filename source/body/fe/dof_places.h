// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include "local_dofs.h"

#include <orthocone/base/ranks.h>
#include <orthocone/body/shapes/boundary.h>
#include <orthocone/body/shapes/curved_cells.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
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

/// Sums of the measures of faces and of their first moments; by quadrature where edges are curved.
template<int dim>
class FaceMoments
{
public:
  FaceMoments(const dealii::Mapping<dim> &mapping, const bool is_curved)
      : is_curved_(is_curved),
        fe_(1),
        values_(mapping, fe_, dealii::QGauss<dim - 1>(n_points),
                dealii::update_JxW_values | dealii::update_quadrature_points)
  {
  }

  void add(const typename dealii::Triangulation<dim>::active_cell_iterator &cell, const unsigned int number)
  {
    const auto face = cell->face(number);
    if (!is_curved_)
      return add(measure_of(face), in_space(face->center()));
    values_.reinit(cell, number);
    for (const unsigned int q : values_.quadrature_point_indices())
      add(values_.JxW(q), in_space(values_.quadrature_point(q)));
  }

  double area = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();

private:
  static constexpr unsigned int n_points = 5;

  void add(const double measure, const Eigen::Vector3d &centre)
  {
    area += measure;
    moment += measure * centre;
  }

  bool is_curved_;
  dealii::FE_Q<dim> fe_;
  dealii::FEFaceValues<dim> values_;
};

/// Centroid of the held face of the whole body (mm): the centroid of the modelled part, moved into the planes
/// of symmetry, or onto the axis.
template<int dim>
Eigen::Vector3d held_centre_of(const dealii::Mapping<dim> &mapping,
                               const dealii::Triangulation<dim> &triangulation)
{
  FaceMoments<dim> sums(mapping, has_curved_cells(triangulation));
  Eigen::Vector3d is_inside = Eigen::Vector3d::Ones();
  double extent = 0;
  const auto add = [&](const auto &cell, const unsigned int number)
  {
    const auto face = cell->face(number);
    if (face->boundary_id() == Boundary::plane_normal_to_x || face->boundary_id() == Boundary::axis)
      is_inside[0] = 0;
    if (face->boundary_id() == Boundary::plane_normal_to_y)
      is_inside[1] = 0;
    extent = std::max(extent, in_space(face->center()).norm());
    if (face->boundary_id() == Boundary::top_face)
      sums.add(cell, number);
  };
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary())
          add(cell, face);
  if (is_distributed(triangulation))
  {
    sums.area = sum_over_ranks(sums.area);
    sum_over_ranks(sums.moment.data(), 3);
    extent = largest_of_ranks(extent);
    for (double &inside : is_inside)
      inside = -largest_of_ranks(-inside);
  }
  if (sums.area == 0)
    return Eigen::Vector3d::Zero();
  constexpr double rounding = 1e-12;
  const Eigen::Vector3d centre = is_inside.cwiseProduct(sums.moment / sums.area);
  return (centre.array().abs() < rounding * extent).select(0, centre);
}
} // namespace orthocone
