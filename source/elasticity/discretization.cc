// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "dof_ranges.h"

#include <orthocone/elasticity/discretization.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

namespace orthocone
{
namespace
{
constexpr unsigned int dim = 3;
} // namespace

Discretization::Discretization(const dealii::Triangulation<3> &triangulation, const MeshOptions &options,
                               const TopFace top_face)
    : scalar_fe_(options.degree),
      fe_(scalar_fe_, dim),
      mapping_(options.degree),
      dof_handler_(triangulation),
      n_quadrature_points_(options.n_quadrature_points()),
      volumetric_quadrature_(options.volumetric_quadrature)
{
  dof_handler_.distribute_dofs(fe_);
  n_cells_ = triangulation.n_active_cells();
  const DofRanges ranges = number_by_range(dof_handler_, held_dofs(top_face));
  n_interior_ = ranges.n_interior;
  n_free_ = ranges.n_free;
  directions_ = directions_of<dim>(dof_handler_, {{0, 1, 2}});
  find_contact_surface();
  lump_areas();
}

std::vector<bool> Discretization::held_dofs(const TopFace top_face) const
{
  std::vector<bool> is_held(dof_handler_.n_dofs(), false);
  const bool is_clamped = top_face == TopFace::clamped;
  hold(dof_handler_, Boundary::top_face, {is_clamped, is_clamped, true}, is_held);
  hold(dof_handler_, Boundary::plane_normal_to_x, {true, false, false}, is_held);
  hold(dof_handler_, Boundary::plane_normal_to_y, {false, true, false}, is_held);
  return is_held;
}

void Discretization::find_contact_surface()
{
  contact_surface_.degree = scalar_fe_.degree;
  std::vector<unsigned int> node_of_dof(n_dofs(), dealii::numbers::invalid_unsigned_int);
  for (const auto &cell : dof_handler_.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == Boundary::contact_surface)
        add_contact_face(cell, face, node_of_dof);
}

void Discretization::add_contact_face(const dealii::DoFHandler<3>::active_cell_iterator &cell,
                                      const unsigned int face, std::vector<unsigned int> &node_of_dof)
{
  // Extruded cells have the contact surface at their lower face, where the lexicographic numbering begins.
  AssertThrow(face == dealii::GeometryInfo<3>::faces_per_cell - 2,
              dealii::ExcMessage("the contact surface is not the lower face of an extruded cell"));
  const unsigned int n_face_nodes = (scalar_fe_.degree + 1) * (scalar_fe_.degree + 1);
  const auto hierarchic = dealii::FETools::lexicographic_to_hierarchic_numbering<3>(scalar_fe_.degree);
  std::vector<dealii::types::global_dof_index> dofs(fe_.n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  std::vector<unsigned int> nodes;
  for (unsigned int i = 0; i < n_face_nodes; ++i)
  {
    ContactNode node{};
    for (unsigned int d = 0; d < dim; ++d)
    {
      node.dofs[d] = dofs[fe_.component_to_system_index(d, hierarchic[i])];
      node.is_free[d] = node.dofs[d] < n_free_;
    }
    unsigned int &number = node_of_dof[node.dofs[dim - 1]];
    if (number == dealii::numbers::invalid_unsigned_int)
    {
      const auto point =
          mapping_.transform_unit_to_real_cell(cell, scalar_fe_.unit_support_point(hierarchic[i]));
      node.position = {{point[0], point[1]}};
      number = contact_surface_.nodes.size();
      contact_surface_.nodes.push_back(node);
    }
    nodes.push_back(number);
  }
  contact_surface_.faces.push_back(nodes);
}

void Discretization::lump_areas()
{
  const dealii::QGauss<2> quadrature(scalar_fe_.degree + 1);
  dealii::FEFaceValues<3> values(mapping_, scalar_fe_, quadrature,
                                 dealii::update_values | dealii::update_JxW_values);
  const auto hierarchic = dealii::FETools::lexicographic_to_hierarchic_numbering<3>(scalar_fe_.degree);
  auto nodes = contact_surface_.faces.begin();
  for (const auto &cell : dof_handler_.get_triangulation().active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == Boundary::contact_surface)
      {
        values.reinit(cell, face);
        for (unsigned int i = 0; i < nodes->size(); ++i)
          for (const unsigned int q : values.quadrature_point_indices())
            contact_surface_.nodes[(*nodes)[i]].area += values.shape_value(hierarchic[i], q) * values.JxW(q);
        ++nodes;
      }
  for (const ContactNode &node : contact_surface_.nodes)
    AssertThrow(node.area > 0,
                dealii::ExcMessage("the mesh is too distorted: a contact node has no positive area"));
}
} // namespace orthocone
