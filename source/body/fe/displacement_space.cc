// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/fe/displacement_space.h>

#include "dof_places.h"
#include "dof_ranges.h"

#include <orthocone/base/numbers.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

namespace orthocone
{
namespace
{
/// The lower face of a cell, where the lexicographic numbering begins.
template<int dim>
constexpr unsigned int lower_face = dealii::GeometryInfo<dim>::faces_per_cell - 2;

/// Direction in which a component moves.
template<int dim>
std::array<unsigned char, dim> directions();
template<>
std::array<unsigned char, 2> directions<2>()
{
  return {{0, 2}};
}
template<>
std::array<unsigned char, 3> directions<3>()
{
  return {{0, 1, 2}};
}

/// What a point of the section stands for in its ring; of a solid, 1.
template<int dim>
double ring_length(const dealii::Point<dim> &point)
{
  return dim == 2 ? 2 * pi * point[0] : 1;
}

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

template<int dim>
DisplacementSpace<dim>::DisplacementSpace(const dealii::Triangulation<dim> &triangulation,
                                          const MeshOptions &options, const TopFace top_face)
    : scalar_fe_(options.degree),
      fe_(scalar_fe_, dim),
      mapping_(dim == 2 ? 1 : options.degree), // sections are rectangles
      dof_handler_(triangulation),
      n_quadrature_points_(options.n_quadrature_points()),
      volumetric_quadrature_(options.volumetric_quadrature),
      hierarchic_(dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(options.degree))
{
  n_cells_ = triangulation.n_active_cells();
  dof_handler_.distribute_dofs(fe_);
  const DofRanges ranges = number_by_range(dof_handler_, held_dofs(top_face));
  n_interior_ = ranges.n_interior;
  n_free_ = ranges.n_free;
  if (ranges.n_not_hanging < dof_handler_.n_dofs())
    hanging_ = HangingDofs(ranges.n_not_hanging, hanging_sums(dof_handler_, ranges));
  directions_ = directions_of<dim>(dof_handler_, directions<dim>());
  positions_ = positions_of(mapping_, dof_handler_);
  held_centre_ = held_centre_of(triangulation);
  if (dim == 2)
    make_axis_face_basis();
  find_contact_surface();
}

template<int dim>
std::vector<bool> DisplacementSpace<dim>::held_dofs(const TopFace top_face) const
{
  std::vector<bool> is_held(dof_handler_.n_dofs(), false);
  std::vector<bool> of_top(dim, top_face == TopFace::clamped);
  of_top.back() = true;
  hold(dof_handler_, Boundary::top_face, of_top, is_held);
  const auto hold_component = [&](const Boundary boundary, const unsigned int component)
  {
    std::vector<bool> held(dim, false);
    held[component] = true;
    hold(dof_handler_, boundary, held, is_held);
  };
  hold_component(dim == 2 ? Boundary::axis : Boundary::plane_normal_to_x, 0);
  if (dim == 3)
    hold_component(Boundary::plane_normal_to_y, 1);
  return is_held;
}

template<int dim>
bool DisplacementSpace<dim>::has_axis_face(const Cell &cell) const
{
  const auto is_at = [&](const unsigned int face, const Boundary boundary)
  { return cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == boundary; };
  return dim == 2 && is_at(0, Boundary::axis) && is_at(lower_face<dim>, Boundary::contact_surface);
}

template<int dim>
void DisplacementSpace<dim>::make_axis_face_basis()
{
  axis_face_points_ = gauss_lobatto_jacobi_points(scalar_fe_.degree);
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

template<int dim>
void DisplacementSpace<dim>::find_contact_surface()
{
  contact_surface_.degree = scalar_fe_.degree;
  node_of_dof_.assign(n_dofs(), dealii::numbers::invalid_unsigned_int);
  for (const auto &cell : dof_handler_.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == Boundary::contact_surface)
      {
        AssertThrow(face == lower_face<dim>,
                    dealii::ExcMessage("the contact surface is not the lower face of a cell"));
        add_contact_face(cell);
      }
  separate_hanging_nodes();
  for (const ContactNode &node : contact_surface_.nodes)
    AssertThrow(node.area > 0,
                dealii::ExcMessage("the mesh is too distorted: a contact node has no positive area"));
}

/// Numbers them behind the contact nodes, which get their areas.
template<int dim>
void DisplacementSpace<dim>::separate_hanging_nodes()
{
  if (hanging_.empty())
    return;
  std::vector<ContactNode> all;
  std::swap(all, contact_surface_.nodes);
  const auto hangs = [&](const ContactNode &node) { return hanging_.contains(node.dofs[2]); };
  std::vector<unsigned int> new_number(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!hangs(all[i]))
    {
      new_number[i] = node_of_dof_[all[i].dofs[2]] = contact_surface_.nodes.size();
      contact_surface_.nodes.push_back(all[i]);
    }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (hangs(all[i]))
      new_number[i] = hanging_place(all[i]);
  for (auto &face : contact_surface_.faces)
    for (unsigned int &place : face)
      place = new_number[place];
}

/// Number of the place where a node hangs, whose area goes to the contact nodes that move it. In the middle
/// of an edge of even degree this is a contact node.
template<int dim>
unsigned int DisplacementSpace<dim>::hanging_place(ContactNode hanging)
{
  std::vector<HangingNode::Term> terms;
  for (const HangingDofs::Term &term : hanging_.terms(hanging.dofs[2]))
  {
    terms.push_back({node_of_dof_[term.dof], term.weight});
    contact_surface_.nodes[terms.back().node].area += term.weight * hanging.area;
  }
  if (terms.size() == 1)
    return terms.front().node;
  hanging.area = 0;
  contact_surface_.hanging.push_back({hanging, terms});
  return contact_surface_.n_places() - 1;
}

template<int dim>
void DisplacementSpace<dim>::add_contact_face(const Cell &cell)
{
  Eigen::VectorXd weights = face_weights(cell);
  if (has_axis_face(cell))
    weights = axis_face_values_.transpose() * weights;
  std::vector<unsigned int> nodes;
  for (unsigned int i = 0; i < weights.size(); ++i)
  {
    nodes.push_back(contact_node(cell, i));
    contact_surface_.nodes[nodes.back()].area += weights[i];
  }
  contact_surface_.faces.push_back(nodes);
  contact_cells_.push_back(cell->active_cell_index());
}

/// Number of a node of a contact face, which is added if it is new.
template<int dim>
unsigned int DisplacementSpace<dim>::contact_node(const Cell &cell, const unsigned int point)
{
  std::vector<dealii::types::global_dof_index> dofs(fe_.n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  ContactNode node{};
  // Nothing moves around the axis: a section has no such degree of freedom.
  node.dofs.fill(dealii::numbers::invalid_unsigned_int);
  for (unsigned int c = 0; c < dim; ++c)
  {
    const unsigned int direction = directions<dim>()[c];
    node.dofs[direction] = dofs[fe_.component_to_system_index(c, hierarchic_[point])];
    node.is_free[direction] = node.dofs[direction] < n_free_ || hanging_.contains(node.dofs[direction]);
  }
  unsigned int &number = node_of_dof_[node.dofs[2]];
  if (number != dealii::numbers::invalid_unsigned_int)
    return number;
  dealii::Point<dim> unit_point = scalar_fe_.unit_support_point(hierarchic_[point]);
  if (has_axis_face(cell))
    unit_point[0] = axis_face_points_[point];
  const Eigen::Vector3d place = in_space(mapping_.transform_unit_to_real_cell(cell, unit_point));
  for (unsigned int c = 0; c < dim; ++c)
    positions_.col(node.dofs[directions<dim>()[c]]) = place;
  node.position = {{place[0], place[1]}};
  node.height = place[2];
  number = contact_surface_.nodes.size();
  contact_surface_.nodes.push_back(node);
  return number;
}

/// Integrals of the shape functions of FE_Q over a contact face, or its ring, mm^2.
template<int dim>
Eigen::VectorXd DisplacementSpace<dim>::face_weights(const Cell &cell) const
{
  dealii::FEFaceValues<dim> values(mapping_, scalar_fe_, dealii::QGauss<dim - 1>(scalar_fe_.degree + 1),
                                   dealii::update_values | dealii::update_quadrature_points |
                                       dealii::update_JxW_values);
  values.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell), lower_face<dim>);
  const unsigned int n_side = scalar_fe_.degree + 1;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(dim == 2 ? n_side : n_side * n_side);
  for (unsigned int i = 0; i < weights.size(); ++i)
    for (const unsigned int q : values.quadrature_point_indices())
      weights[i] += values.shape_value(hierarchic_[i], q) *
                    (ring_length<dim>(values.quadrature_point(q)) * values.JxW(q));
  return weights;
}

template class DisplacementSpace<2>;
template class DisplacementSpace<3>;
} // namespace orthocone
