// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "known_tractions.h"

#include "face_nodes.h"

#include <orthocone/body/shapes/boundary.h>

#include <deal.II/fe/fe_tools.h>

namespace orthocone
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{
Matrix3d matrix_of(const Stress &stress)
{
  Matrix3d matrix;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      matrix(i, j) = stress[i][j];
  return matrix;
}

/// The strain of the displacement a (n . x), which leaves the surface with the normal n unstrained.
Strain strain_across(const Vector3d &a, const Vector3d &normal)
{
  Strain strain;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      strain[i][j] = (a[i] * normal[j] + a[j] * normal[i]) / 2;
  return strain;
}

/// Outward and of length 1, at a point in a face of the unit cell.
template<int dim>
Vector3d normal_at(const dealii::FEValues<dim> &values, const unsigned int q, const unsigned int face)
{
  const auto &to_unit = values.inverse_jacobian(q);
  Vector3d normal = Vector3d::Zero();
  for (unsigned int d = 0; d < dim; ++d)
    normal[dim == 2 && d == 1 ? 2 : d] = (face % 2 == 1 ? 1 : -1) * to_unit[face / 2][d];
  return normal.normalized();
}
} // namespace

template<int dim>
KnownTractions<dim>::KnownTractions(const DisplacementSpace<dim> &space,
                                    const std::vector<Vector3d> &of_nodes)
    : space_(space),
      of_nodes_(of_nodes)
{
  for (unsigned int face = 0; face < space.contact_cells().size(); ++face)
    contact_faces_[space.contact_cells()[face]].push_back(face);
}

template<int dim>
Vector3d KnownTractions<dim>::of_place(const unsigned int place) const
{
  const ContactSurface &surface = space_.contact_surface();
  if (place < surface.nodes.size())
    return of_nodes_[place];
  Vector3d sum = Vector3d::Zero();
  for (const HangingNode::Term &term : surface.hanging[place - surface.nodes.size()].terms)
    sum += term.weight * of_nodes_[term.node];
  return sum;
}

/// Interpolated between the nodes of the face as the displacement is.
template<int dim>
Vector3d KnownTractions<dim>::of_contact(const Cell &cell, const unsigned int face, const unsigned int number,
                                         const dealii::Point<dim> &unit) const
{
  const std::vector<unsigned int> &places = space_.contact_surface().faces[number];
  std::vector<unsigned int> nodes = nodes_of_face<dim>(face, space_.scalar_fe().degree);
  const auto hierarchic =
      dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(space_.scalar_fe().degree);
  for (unsigned int &node : nodes)
    node = hierarchic[node];
  const bool is_on_axis = space_.has_axis_face(cell);
  const unsigned int n = space_.n_components();
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    Vector3d of_node = Vector3d::Zero();
    if (is_on_axis)
      for (std::size_t j = 0; j < nodes.size(); ++j)
        of_node += space_.axis_face_basis()(n * nodes[i], n * nodes[j]) * of_place(places[j]);
    else
      of_node = of_place(places[i]);
    sum += space_.scalar_fe().shape_value(nodes[i], unit) * of_node;
  }
  return sum;
}

template<int dim>
std::optional<typename KnownTractions<dim>::KnownFace>
KnownTractions<dim>::face_at(const Cell &cell, const dealii::Point<dim> &unit) const
{
  constexpr double rounding = 1e-7; // in sizes of the cell
  std::optional<KnownFace> free;
  std::size_t k = 0;
  for (const unsigned int face : cell->face_indices())
  {
    if (!cell->at_boundary(face))
      continue;
    const bool is_there = std::abs(unit[face / 2] - face % 2) <= rounding;
    const auto id = cell->face(face)->boundary_id();
    if (is_contact(id))
    {
      const unsigned int number = contact_faces_.at(cell->active_cell_index()).at(k++);
      if (is_there)
        return KnownFace{face, number};
    }
    else if (is_there && id == Boundary::lateral_surface)
      free = KnownFace{face, std::nullopt};
    else if (is_there && id != Boundary::plane_normal_to_x && id != Boundary::plane_normal_to_y &&
             id != Boundary::axis)
      return std::nullopt; // an edge of what is held or loaded
  }
  return free;
}

template<int dim>
const dealii::FEValues<dim> &KnownTractions<dim>::jacobians(const Cell &cell,
                                                            const std::vector<dealii::Point<dim>> &units)
{
  if (!jacobians_ || jacobians_->get_quadrature().get_points() != units)
    jacobians_ = std::make_unique<dealii::FEValues<dim>>(space_.mapping(), space_.scalar_fe(),
                                                         dealii::Quadrature<dim>(units),
                                                         dealii::update_inverse_jacobians);
  jacobians_->reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell));
  return *jacobians_;
}

template<int dim>
std::vector<std::optional<SurfaceTraction>>
KnownTractions<dim>::at(const Cell &cell, const std::vector<dealii::Point<dim>> &units)
{
  std::vector<std::optional<SurfaceTraction>> known(units.size());
  if (of_nodes_.empty() || !cell->at_boundary())
    return known;
  const dealii::FEValues<dim> *values = nullptr;
  for (unsigned int i = 0; i < units.size(); ++i)
    if (const auto found = face_at(cell, units[i]))
    {
      values = values != nullptr ? values : &jacobians(cell, units);
      known[i] = SurfaceTraction{normal_at(*values, i, found->face),
                                 found->number ? of_contact(cell, found->face, *found->number, units[i])
                                               : Vector3d(Vector3d::Zero())};
    }
  return known;
}

// The strain in the surface is known better than that across it, because it follows from the displacement of
// the surface alone. What the traction asks for is therefore added as a strain sym(a x n) that leaves the
// surface as it is: C sym(a x n) n = t - sigma n, three equations for a, whose matrix is Christoffel's of the
// normal n. It is positive definite wherever the material stores energy.
Stress with_traction(const Stress &stress, const Material &material, const SurfaceTraction &of)
{
  Matrix3d christoffel;
  for (unsigned int i = 0; i < 3; ++i)
    christoffel.col(i) = matrix_of(material.stress(strain_across(Vector3d::Unit(i), of.normal))) * of.normal;
  const Vector3d a = christoffel.llt().solve(of.traction - matrix_of(stress) * of.normal);
  return stress + material.stress(strain_across(a, of.normal));
}

template class KnownTractions<2>;
template class KnownTractions<3>;
} // namespace orthocone
