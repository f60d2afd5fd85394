// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/fe/cell_fields.h>

#include "dof_places.h"
#include "strain_terms.h"
#include <orthocone/body/fe/cell_dofs.h>

#include <deal.II/base/quadrature_lib.h>

namespace orthocone
{
using Eigen::VectorXd;

namespace
{
/// Strain from values at the nodes, numbered n_components a + c.
template<int dim>
Strain strain_at(const DisplacementSpace<dim> &space, const dealii::FEValues<dim> &values,
                 const unsigned int q, const VectorXd &nodal)
{
  const StrainTerms<dim> strain_terms(space.section());
  const unsigned int n_components = space.n_components();
  dealii::Tensor<2, 3> gradient;
  for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
  {
    const Eigen::Vector3d terms = strain_terms.of(values, a, q);
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int m = 0; m < 3; ++m)
        if (const auto place = strain_terms.place(c, m))
          gradient[place->row][place->column] += place->sign * nodal[n_components * a + c] * terms[m];
  }
  return symmetrize(gradient);
}

template<int dim>
Eigen::Vector3d displacement_at(const DisplacementSpace<dim> &space, const dealii::FEValues<dim> &values,
                                const unsigned int q, const VectorXd &nodal)
{
  const unsigned int n_components = space.n_components();
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();
  for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
    for (unsigned int c = 0; c < n_components; ++c)
      displacement[space.direction_of(c)] += nodal[n_components * a + c] * values.shape_value(a, q);
  return displacement;
}

const dealii::UpdateFlags needed =
    dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points;
} // namespace

template<int dim>
CellFields<dim>::CellFields(const DisplacementSpace<dim> &space, const Materials &materials,
                            const dealii::Quadrature<dim> &points, const VectorXd &displacement,
                            const Strain &free_strain)
    : space_(space),
      displacement_(displacement),
      free_strain_(free_strain),
      materials_(materials),
      values_(space.mapping(), space.scalar_fe(), points, needed),
      quadrature_values_(space.mapping(), space.scalar_fe(), dealii::QGauss<dim>(space.n_quadrature_points()),
                         needed | dealii::update_JxW_values),
      divergence_(space.scalar_fe().degree)
{
}

/// Values at the nodes of FE_Q, numbered n_components a + c.
template<int dim>
VectorXd CellFields<dim>::nodal_values(const typename DisplacementSpace<dim>::Cell &cell) const
{
  const auto dofs = dofs_by_node(space_, cell);
  VectorXd values(dofs.size());
  for (std::size_t i = 0; i < dofs.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = displacement_[static_cast<Eigen::Index>(dofs[i])];
  return space_.has_axis_face(cell) ? VectorXd(space_.axis_face_basis() * values) : values;
}

/// At the points of `values_`, which is at the cell.
template<int dim>
VectorXd CellFields<dim>::projected_volume_changes(const typename DisplacementSpace<dim>::Cell &cell,
                                                   const VectorXd &nodal)
{
  quadrature_values_.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell));
  divergence_.reset(cell, 1);
  for (const unsigned int q : quadrature_values_.quadrature_point_indices())
    divergence_.add(quadrature_values_.quadrature_point(q),
                    VectorXd::Constant(1, trace(strain_at(space_, quadrature_values_, q, nodal))),
                    StrainTerms<dim>(space_.section()).volume(quadrature_values_, q));
  const VectorXd coefficients = divergence_.coefficients();
  VectorXd changes(values_.n_quadrature_points);
  for (const unsigned int q : values_.quadrature_point_indices())
    changes[q] = coefficients.dot(divergence_.polynomials_at(values_.quadrature_point(q)));
  return changes;
}

template<int dim>
std::vector<PointFields> CellFields<dim>::in(const typename DisplacementSpace<dim>::Cell &cell)
{
  const bool is_projected = space_.volumetric_quadrature() == VolumetricQuadrature::projected;
  const VectorXd nodal = nodal_values(cell);
  values_.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell));
  const VectorXd changes = is_projected ? projected_volume_changes(cell, nodal) : VectorXd();
  std::vector<PointFields> fields(values_.n_quadrature_points);
  for (const unsigned int q : values_.quadrature_point_indices())
  {
    const Strain strain = strain_at(space_, values_, q, nodal);
    fields[q].place = in_space(values_.quadrature_point(q));
    fields[q].displacement = displacement_at(space_, values_, q, nodal);
    fields[q].volume = cell->material_id();
    fields[q].volume_change = (is_projected ? changes[q] : trace(strain)) - trace(free_strain_);
    fields[q].stress =
        materials_.of(cell->material_id()).stress(strain - free_strain_, fields[q].volume_change);
  }
  return fields;
}

template class CellFields<2>;
template class CellFields<3>;
} // namespace orthocone
