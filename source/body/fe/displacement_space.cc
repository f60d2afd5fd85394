// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/fe/displacement_space.h>

#include "contact_faces.h"
#include "datum.h"
#include "dof_places.h"
#include "face_nodes.h"
#include "local_dofs.h"
#include "stress_patches.h"

#include <orthocone/base/ranks.h>
#include <orthocone/body/shapes/curved_cells.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_cache.h>

#include <cmath>
#include <map>
#include <utility>

namespace orthocone
{
namespace
{
/// The nodes of the lower face of a cell, where the lexicographic numbering begins.
template<int dim>
constexpr unsigned int lower_face = dealii::GeometryInfo<dim>::faces_per_cell - 2;

/// Points in [0, 1], both ends among them, of the rule with weight r that is exact to degree 2 * degree - 1.
std::vector<double> gauss_lobatto_jacobi_points(const unsigned int degree)
{
  std::vector<double> points{0};
  // The inner points are the zeros of the polynomial that is orthogonal with weight (1 - r) r^2, which
  // vanishes at both ends.
  for (const double point : dealii::Polynomials::jacobi_polynomial_roots<double>(degree - 1, 1, 2))
    points.push_back(point);
  points.push_back(1);
  return points;
}

/// A mapping of this degree. Manifolds are asked once for the places of a cell's points, which takes most of
/// the time of fields in curved cells, unless these places would fill the memory.
template<int dim>
std::shared_ptr<const dealii::MappingQ<dim>> make_mapping(const dealii::Triangulation<dim> &triangulation,
                                                          const unsigned int degree)
{
  constexpr double most_bytes = 64e6;
  const double bytes =
      std::pow(degree + 1, dim) * sizeof(dealii::Point<dim>) * static_cast<double>(triangulation.n_cells());
  if (degree == 1 || bytes > most_bytes)
    return std::make_shared<const dealii::MappingQ<dim>>(degree);
  const auto mapping = std::make_shared<dealii::MappingQCache<dim>>(degree);
  mapping->initialize(dealii::MappingQ<dim>(degree), triangulation);
  return mapping;
}
} // namespace

template<int dim>
DisplacementSpace<dim>::DisplacementSpace(const dealii::Triangulation<dim> &triangulation,
                                          const MeshOptions &options, const HeldSurfaces &held,
                                          const SectionModel &section)
    : section_(section),
      contact_faces_down_(held.contact_faces_down),
      scalar_fe_(options.degree),
      fe_(scalar_fe_, n_components()),
      // The cells of sections have straight edges but for those of a file of second order.
      mapping_(
          make_mapping(triangulation, dim == 2 && !has_curved_cells(triangulation) ? 1 : options.degree)),
      dof_handler_(triangulation),
      n_quadrature_points_(options.n_quadrature_points()),
      volumetric_quadrature_(options.resolved_volumetric_quadrature()),
      hierarchic_(dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(options.degree))
{
  dof_handler_.distribute_dofs(fe_);
  const Datum datum = datum_of(triangulation, held, section_);
  loose_components_ = datum.components;
  const DofRanges ranges = number_by_range(dof_handler_, held_dofs(held, datum).all);
  n_interior_ = ranges.n_interior;
  n_free_ = ranges.n_free;
  n_owned_ = dof_handler_.n_locally_owned_dofs();
  size_ = {static_cast<unsigned int>(triangulation.n_global_active_cells()),
           static_cast<unsigned int>(dof_handler_.n_dofs()),
           static_cast<unsigned int>(is_shared() ? sum_over_ranks(n_free_) : n_free_)};
  held_ = held_dofs(held, datum);
  const auto hanging = hanging_constraints(dof_handler_);
  partitioner_ = make_partitioner(dof_handler_, hanging);
  hanging_ = local_hanging_dofs(*partitioner_, hanging, held_.all);
  for (const auto dof : held_.supported)
    if (partitioner_->in_local_range(dof) || partitioner_->is_ghost_entry(dof))
      supported_.push_back(local_dof(dof));
  DofPlaces places = places_of<dim>(*mapping_, dof_handler_, *partitioner_,
                                    [this](const unsigned int component) { return direction_of(component); });
  directions_ = std::move(places.directions);
  positions_ = std::move(places.positions);
  held_centre_ = held_centre_of(*mapping_, triangulation);
  if (dim == 2)
    make_axis_face_basis();
  find_contact_surface(hanging);
}

template<int dim>
dealii::IndexSet DisplacementSpace<dim>::dofs_on(const dealii::types::boundary_id boundary,
                                                 const std::array<bool, 3> &directions) const
{
  std::vector<bool> components(n_components());
  for (unsigned int c = 0; c < components.size(); ++c)
    components[c] = directions[direction_of(c)];
  return dealii::DoFTools::extract_boundary_dofs(dof_handler_, dealii::ComponentMask(components), {boundary});
}

// The held face is one rigid plate: what it holds it moves, also where a support has the same node. Nodes of
// the contact surface stay free along the normal, because only the counterface may hold them there.
template<int dim>
typename DisplacementSpace<dim>::HeldDofs DisplacementSpace<dim>::held_dofs(const HeldSurfaces &held,
                                                                            const Datum &datum) const
{
  constexpr std::array<bool, 3> x{{true, false, false}}, y{{false, true, false}}, z{{false, false, true}};
  const bool is_clamped = held.top_face == TopFace::clamped;
  HeldDofs dofs{dealii::IndexSet(dof_handler_.n_dofs()), dealii::IndexSet(dof_handler_.n_dofs())};
  if (held.top_face != TopFace::free)
    dofs.all.add_indices(dofs_on(Boundary::top_face, {{is_clamped, is_clamped, true}}));
  add_datum(datum, dofs.all);
  dofs.all.add_indices(dofs_on(Boundary::plane_normal_to_x, x));
  if (dim == 3)
    dofs.all.add_indices(dofs_on(Boundary::plane_normal_to_y, y));
  else // what is the same all around does not move on the axis
    dofs.all.add_indices(dofs_on(Boundary::axis, {{true, true, false}}));
  for (const HeldBoundary &support : held.supports)
    dofs.supported.add_indices(dofs_on(support.id, support.directions));
  if (!held.supports.empty())
    dofs.supported.subtract_set(held.contact_faces_down ? dofs_of_contact(z) : dofs_along_contact_normals());
  dofs.supported.subtract_set(dofs.all);
  dofs.all.add_indices(dofs.supported);
  dofs.all.compress();
  return dofs;
}

template<int dim>
dealii::IndexSet DisplacementSpace<dim>::dofs_of_contact(const std::array<bool, 3> &directions) const
{
  dealii::IndexSet all(dof_handler_.n_dofs());
  for (const auto boundary : contact_boundaries())
    all.add_indices(dofs_on(boundary, directions));
  return all;
}

/// Degrees of freedom of contact nodes along the normal of the body there, or within 60 degrees of it: where
/// a roller stands across a curved surface, as a plane of symmetry does, the normal of a facet may be off the
/// roller's plane by half of the angle between facets.
template<int dim>
dealii::IndexSet DisplacementSpace<dim>::dofs_along_contact_normals() const
{
  constexpr double least = 0.5; // cosine
  dealii::IndexSet all(dof_handler_.n_dofs());
  const dealii::Quadrature<dim - 1> nodes(scalar_fe_.get_unit_face_support_points());
  dealii::FEFaceValues<dim> values(*mapping_, scalar_fe_, nodes, dealii::update_normal_vectors);
  std::vector<dealii::types::global_dof_index> dofs(fe_.n_dofs_per_face());
  for (const auto &cell : dof_handler_.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (!cell->is_artificial() && cell->face(face)->at_boundary() &&
          is_contact(cell->face(face)->boundary_id()))
      {
        values.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell), face);
        cell->face(face)->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          const auto [component, node] = fe_.face_system_to_component_index(i);
          const Eigen::Vector3d normal = in_space(dealii::Point<dim>(values.normal_vector(node)));
          if (std::abs(normal[direction_of(component)]) > least)
            all.add_index(dofs[i]);
        }
      }
  return all;
}

template<int dim>
void DisplacementSpace<dim>::add_datum(const Datum &datum, dealii::IndexSet &dofs) const
{
  for (const auto &[vertex, direction] : datum.held)
    for (const auto &cell : dof_handler_.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (!cell->is_artificial() && cell->vertex_index(v) == vertex)
          for (unsigned int c = 0; c < n_components(); ++c)
            if (direction_of(c) == direction)
              dofs.add_index(cell->vertex_dof_index(v, c));
}

template<int dim>
bool DisplacementSpace<dim>::is_shared() const
{
  return is_distributed(dof_handler_.get_triangulation());
}

template<int dim>
dealii::AffineConstraints<double> DisplacementSpace<dim>::constraints() const
{
  const auto hanging = hanging_constraints(dof_handler_);
  dealii::AffineConstraints<double> all(hanging.get_local_lines());
  for (const auto dof : held_.all)
    all.add_line(dof);
  all.close();
  all.merge(hanging, dealii::AffineConstraints<double>::left_object_wins, true);
  return all;
}

template<int dim>
bool DisplacementSpace<dim>::has_axis_face(const Cell &cell) const
{
  const auto at = [&](const unsigned int face) { return cell->face(face); };
  return dim == 2 && at(0)->at_boundary() && at(0)->boundary_id() == Boundary::axis &&
         at(lower_face<dim>)->at_boundary() && is_contact(at(lower_face<dim>)->boundary_id());
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
      for (unsigned int c = 0; c < n_components(); ++c)
        axis_face_basis_(n_components() * hierarchic_[i] + c, n_components() * hierarchic_[j] + c) =
            axis_face_values_(i, j);
    }
}

template<int dim>
void DisplacementSpace<dim>::find_contact_surface(const dealii::AffineConstraints<double> &hanging)
{
  dealii::FEFaceValues<dim> values(*mapping_, scalar_fe_, dealii::QGauss<dim - 1>(scalar_fe_.degree + 1),
                                   dealii::update_values | dealii::update_quadrature_points |
                                       dealii::update_normal_vectors | dealii::update_JxW_values);
  std::vector<ContactFace> faces;
  std::map<dealii::CellId, unsigned int> cells;
  for (const auto &cell : dof_handler_.active_cell_iterators())
    if (cell->is_locally_owned())
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary() && is_contact(cell->face(face)->boundary_id()))
        {
          const auto nodes = nodes_of_face<dim>(face, scalar_fe_.degree);
          values.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell), face);
          faces.push_back(contact_face(cell, nodes, face_weights(values, nodes), hanging));
          faces.back().surface = contact_number(cell->face(face)->boundary_id());
          cells[common_id(cell)] = cell->active_cell_index();
        }
  const ContactFaces all(std::move(faces), is_shared());
  contact_surface_ = all.surface(scalar_fe_.degree, *partitioner_, contact_faces_down_);
  for (const ContactFace &face : all.faces())
    contact_cells_.push_back(cells.count(face.cell) > 0 ? cells[face.cell]
                                                        : dealii::numbers::invalid_unsigned_int);
  for (const ContactNode &node : contact_surface_.nodes)
    AssertThrow(node.area > 0,
                dealii::ExcMessage("the mesh is too distorted: a contact node has no positive area"));
}

template<int dim>
ContactFace DisplacementSpace<dim>::contact_face(const Cell &cell, const std::vector<unsigned int> &nodes,
                                                 Eigen::MatrixX4d weights,
                                                 const dealii::AffineConstraints<double> &hanging)
{
  if (has_axis_face(cell))
    weights = axis_face_values_.transpose() * weights;
  ContactFace face{common_id(cell), {}, 0};
  for (unsigned int point = 0; point < weights.rows(); ++point)
  {
    face.nodes.push_back(face_node(cell, nodes[point]));
    FaceNode &node = face.nodes.back();
    node.weight = weights(point, 0);
    node.inward = {{weights(point, 1), weights(point, 2), weights(point, 3)}};
    node.hangs = hanging.is_constrained(node.dofs[2]) && !held_.all.is_element(node.dofs[2]);
    if (node.hangs)
      for (const auto &mover : *hanging.get_constraint_entries(node.dofs[2]))
        if (!held_.all.is_element(mover.first))
          node.movers.push_back(mover);
  }
  return face;
}

/// Numbers and place of a node of a contact face, by its lexicographic number in the cell.
template<int dim>
FaceNode DisplacementSpace<dim>::face_node(const Cell &cell, const unsigned int point)
{
  std::vector<dealii::types::global_dof_index> dofs(fe_.n_dofs_per_cell());
  cell->get_dof_indices(dofs);
  dealii::Point<dim> unit_point = scalar_fe_.unit_support_point(hierarchic_[point]);
  if (has_axis_face(cell))
    unit_point[0] = axis_face_points_[point];
  const Eigen::Vector3d place = in_space(mapping_->transform_unit_to_real_cell(cell, unit_point));
  FaceNode node{};
  node.place = {{place[0], place[1], place[2]}};
  // A section of two components has no degree of freedom out of its plane, because nothing moves there.
  node.dofs.fill(dealii::numbers::invalid_dof_index);
  for (unsigned int c = 0; c < n_components(); ++c)
  {
    const unsigned int direction = direction_of(c);
    const auto dof = dofs[fe_.component_to_system_index(c, hierarchic_[point])];
    node.dofs[direction] = dof;
    node.is_free[direction] = !held_.all.is_element(dof);
    node.is_supported[direction] = held_.supported.is_element(dof);
    positions_.col(local_dof(dof)) = place;
  }
  return node;
}

/// Integrals of the shape functions of FE_Q over a contact face, its ring or its strip, and behind them the
/// same times the normal (x, y, z) into the body, mm^2.
template<int dim>
Eigen::MatrixX4d DisplacementSpace<dim>::face_weights(const dealii::FEFaceValues<dim> &values,
                                                      const std::vector<unsigned int> &nodes) const
{
  Eigen::MatrixX4d weights = Eigen::MatrixX4d::Zero(static_cast<Eigen::Index>(nodes.size()), 4);
  for (const unsigned int q : values.quadrature_point_indices())
  {
    const double area = (dim == 2 ? section_.length_at(values.quadrature_point(q)[0]) : 1) * values.JxW(q);
    const Eigen::Vector3d inward = in_space(dealii::Point<dim>(-values.normal_vector(q)));
    for (unsigned int i = 0; i < weights.rows(); ++i)
    {
      const double weight = values.shape_value(hierarchic_[nodes[i]], q) * area;
      weights(i, 0) += weight;
      weights.row(i).tail<3>() += weight * inward.transpose();
    }
  }
  return weights;
}

template<int dim>
const StressPatches<dim> &DisplacementSpace<dim>::stress_patches() const
{
  std::call_once(has_stress_patches_,
                 [this] { stress_patches_ = std::make_shared<StressPatches<dim>>(*this); });
  return *stress_patches_;
}

template class DisplacementSpace<2>;
template class DisplacementSpace<3>;
} // namespace orthocone
