// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "dof_ranges.h"

#include <orthocone/elasticity/axisymmetric_body.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

namespace orthocone
{
namespace
{
constexpr unsigned int dim = 2;
constexpr unsigned int lower_face = 2; // of deal.II's quadrilateral, where the lexicographic numbering begins

/// Points in [0, 1], both ends among them, of the rule with weight r that is exact to degree 2 * degree - 1.
std::vector<double> gauss_lobatto_jacobi_points(const unsigned int degree)
{
  std::vector<double> points{0};
  // Zeros of the polynomial that is orthogonal with weight (1 - r) r^2, which vanishes at the ends.
  for (const double point : dealii::Polynomials::jacobi_polynomial_roots<double>(degree - 1, 1, 2))
    points.push_back(point);
  points.push_back(1);
  return points;
}
} // namespace

SectionDiscretization::SectionDiscretization(const dealii::Triangulation<2> &triangulation,
                                             const MeshOptions &options, const TopFace top_face)
    : scalar_fe_(options.degree),
      fe_(scalar_fe_, dim),
      mapping_(1),
      dof_handler_(triangulation),
      n_quadrature_points_(options.n_quadrature_points()),
      volumetric_quadrature_(options.volumetric_quadrature),
      hierarchic_(dealii::FETools::lexicographic_to_hierarchic_numbering<2>(options.degree)),
      axis_face_points_(gauss_lobatto_jacobi_points(options.degree))
{
  n_cells_ = triangulation.n_active_cells();
  dof_handler_.distribute_dofs(fe_);
  std::vector<bool> is_held(dof_handler_.n_dofs(), false);
  hold(dof_handler_, Boundary::top_face, {top_face == TopFace::clamped, true}, is_held);
  hold(dof_handler_, Boundary::axis, {true, false}, is_held);
  const DofRanges ranges = number_by_range(dof_handler_, is_held);
  n_interior_ = ranges.n_interior;
  n_free_ = ranges.n_free;
  directions_ = directions_of<dim>(dof_handler_, {{0, 2}});
  make_axis_face_basis();
  find_contact_surface();
}

bool SectionDiscretization::has_axis_face(const Cell &cell) const
{
  const auto is_at = [&](const unsigned int face, const Boundary boundary)
  { return cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == boundary; };
  return is_at(0, Boundary::axis) && is_at(lower_face, Boundary::contact_surface);
}

void SectionDiscretization::make_axis_face_basis()
{
  const unsigned int n_side = scalar_fe_.degree + 1;
  std::vector<dealii::Point<1>> points;
  for (const double point : axis_face_points_)
    points.emplace_back(point);
  const auto basis = dealii::Polynomials::generate_complete_Lagrange_basis(points);
  axis_face_values_ = Eigen::MatrixXd::Identity(n_side, n_side);
  axis_face_basis_ = Eigen::MatrixXd::Identity(fe_.n_dofs_per_cell(), fe_.n_dofs_per_cell());
  for (unsigned int i = 1; i < scalar_fe_.degree; ++i)
    for (unsigned int j = 0; j < n_side; ++j)
    {
      axis_face_values_(i, j) = basis[j].value(scalar_fe_.unit_support_point(hierarchic_[i])[0]);
      for (unsigned int c = 0; c < dim; ++c)
        axis_face_basis_(dim * hierarchic_[i] + c, dim * hierarchic_[j] + c) = axis_face_values_(i, j);
    }
}

void SectionDiscretization::find_contact_surface()
{
  contact_surface_.degree = scalar_fe_.degree;
  node_of_dof_.assign(n_dofs(), dealii::numbers::invalid_unsigned_int);
  for (const auto &cell : dof_handler_.active_cell_iterators())
    if (cell->face(lower_face)->at_boundary() &&
        cell->face(lower_face)->boundary_id() == Boundary::contact_surface)
      add_contact_face(cell);
  for (const ContactNode &node : contact_surface_.nodes)
    AssertThrow(node.area > 0, dealii::ExcMessage("a contact node has no positive area"));
}

void SectionDiscretization::add_contact_face(const Cell &cell)
{
  const bool is_on_axis = has_axis_face(cell);
  Eigen::VectorXd weights = face_weights(cell);
  if (is_on_axis)
    weights = axis_face_values_.transpose() * weights;
  const double left = cell->vertex(0)[0];
  const double width = cell->vertex(1)[0] - left;
  std::vector<unsigned int> nodes;
  for (unsigned int i = 0; i <= scalar_fe_.degree; ++i)
  {
    const double place = is_on_axis ? axis_face_points_[i] : scalar_fe_.unit_support_point(hierarchic_[i])[0];
    nodes.push_back(contact_node(cell, i, left + place * width));
    contact_surface_.nodes[nodes.back()].area += weights[i];
  }
  contact_surface_.faces.push_back(nodes);
}

/// Number of a node of a contact face, which is added if it is new.
unsigned int SectionDiscretization::contact_node(const Cell &cell, const unsigned int point,
                                                 const double radius)
{
  std::vector<dealii::types::global_dof_index> dofs(fe_.n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  const auto dof = [&](const unsigned int component) -> unsigned int
  { return dofs[fe_.component_to_system_index(component, hierarchic_[point])]; };
  unsigned int &number = node_of_dof_[dof(1)];
  if (number == dealii::numbers::invalid_unsigned_int)
  {
    number = contact_surface_.nodes.size();
    // Nothing moves around the axis: there is no such degree of freedom.
    contact_surface_.nodes.push_back({{{radius, 0}},
                                      0,
                                      {{dof(0), dealii::numbers::invalid_unsigned_int, dof(1)}},
                                      {{dof(0) < n_free_, false, dof(1) < n_free_}}});
  }
  return number;
}

/// Integrals of the shape functions of FE_Q over the ring of a contact face, mm^2.
Eigen::VectorXd SectionDiscretization::face_weights(const Cell &cell) const
{
  dealii::FEFaceValues<dim> values(mapping_, scalar_fe_, dealii::QGauss<1>(scalar_fe_.degree + 1),
                                   dealii::update_values | dealii::update_quadrature_points |
                                       dealii::update_JxW_values);
  values.reinit(dealii::Triangulation<dim>::active_cell_iterator(cell), lower_face);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(scalar_fe_.degree + 1);
  for (unsigned int i = 0; i < weights.size(); ++i)
    for (const unsigned int q : values.quadrature_point_indices())
      weights[i] += values.shape_value(hierarchic_[i], q) * 2 * dealii::numbers::PI *
                    values.quadrature_point(q)[0] * values.JxW(q);
  return weights;
}
} // namespace orthocone
