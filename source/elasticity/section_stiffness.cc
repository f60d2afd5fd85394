// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "cell_dofs.h"

#include <orthocone/elasticity/projected_divergence.h>
#include <orthocone/elasticity/stiffness.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace orthocone
{
namespace
{
constexpr unsigned int dim = 2;
constexpr unsigned int n_strains = 4; // rr, zz, hoop, 2 rz

/// Stress (rr, zz, hoop, rz) of a strain (rr, zz, hoop, 2 rz).
Eigen::Matrix4d elasticity(const LameParameters &lame)
{
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix.topLeftCorner<3, 3>().setConstant(lame.lambda);
  matrix.diagonal() << lame.lambda + 2 * lame.mu, lame.lambda + 2 * lame.mu, lame.lambda + 2 * lame.mu,
      lame.mu;
  return matrix;
}

/// Columns 2 a + c: strain of the shape function of node a in component c, at a quadrature point.
void fill_strains(const dealii::FEValues<dim> &values, const unsigned int q, Eigen::MatrixXd &strains)
{
  const double radius = values.quadrature_point(q)[0];
  for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
  {
    const auto gradient = values.shape_grad(a, q);
    strains.col(dim * a) << gradient[0], 0, values.shape_value(a, q) / radius, gradient[1];
    strains.col(dim * a + 1) << 0, gradient[1], 0, gradient[0];
  }
}

/// Share of a quadrature point in the volume of the ring of a cell.
double ring_volume(const dealii::FEValues<dim> &values, const unsigned int q)
{
  return 2 * dealii::numbers::PI * values.quadrature_point(q)[0] * values.JxW(q);
}

/// Stiffness of the ring of a cell, numbered as the columns of strains.
Eigen::MatrixXd cell_matrix(const dealii::FEValues<dim> &values, const Eigen::Matrix4d &elasticity)
{
  const Eigen::Index n = static_cast<Eigen::Index>(dim) * values.dofs_per_cell;
  Eigen::MatrixXd strains(n_strains, n);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (const unsigned int q : values.quadrature_point_indices())
  {
    fill_strains(values, q, strains);
    matrix.noalias() += strains.transpose() * (ring_volume(values, q) * elasticity * strains);
  }
  return matrix;
}

/// Integrals over the ring of a cell of the products of projected divergences.
Eigen::MatrixXd divergence_products(const dealii::FEValues<dim> &values, ProjectedDivergence<dim> &divergence)
{
  const Eigen::Index n = static_cast<Eigen::Index>(dim) * values.dofs_per_cell;
  Eigen::MatrixXd strains(n_strains, n);
  divergence.reset(n);
  for (const unsigned int q : values.quadrature_point_indices())
  {
    fill_strains(values, q, strains);
    divergence.add(q, strains.topRows<3>().colwise().sum().transpose(), ring_volume(values, q));
  }
  return divergence.products();
}
} // namespace

Stiffness::Stiffness(const SectionDiscretization &discretization, const MaterialOptions &material)
{
  make_stiffness_pattern(discretization, pattern_);
  matrix_.reinit(pattern_);
  const dealii::QGauss<dim> quadrature(discretization.n_quadrature_points());
  dealii::FEValues<dim> values(discretization.mapping(), discretization.scalar_fe(), quadrature,
                               dealii::update_values | dealii::update_gradients |
                                   dealii::update_quadrature_points | dealii::update_JxW_values);
  const bool is_reduced = discretization.volumetric_quadrature() == VolumetricQuadrature::reduced;
  ProjectedDivergence<dim> divergence(discretization.scalar_fe().degree, quadrature);
  const LameParameters lame(material);
  LameParameters combined = lame; // what cell_matrix() takes care of
  if (is_reduced)
    combined.lambda = 0;
  const Eigen::Matrix4d stress_of_strain = elasticity(combined);
  for (const auto &cell : discretization.dof_handler().active_cell_iterators())
  {
    values.reinit(dealii::Triangulation<dim>::active_cell_iterator(cell));
    Eigen::MatrixXd matrix = cell_matrix(values, stress_of_strain);
    if (is_reduced)
      matrix += lame.lambda * divergence_products(values, divergence);
    if (discretization.has_axis_face(cell))
      matrix = discretization.axis_face_basis().transpose() * matrix * discretization.axis_face_basis();
    add_cell_matrix(matrix, dofs_by_node<dim>(cell), matrix_);
  }
}
} // namespace orthocone
