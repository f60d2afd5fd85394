// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// What the projection of the divergence is for: pressures that converge with their order whatever the form of
// the cells, and contact that stays well conditioned up to incompressibility.
#include "body/bodies.h"

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
MaterialOptions nearly_incompressible()
{
  MaterialOptions material;
  material.young_modulus = 3;
  material.poisson_ratio = 0.4999;
  return material;
}

MeshOptions projected_mesh(const unsigned int degree)
{
  MeshOptions options;
  options.degree = degree;
  options.volumetric_quadrature = VolumetricQuadrature::projected;
  return options;
}

/// A displacement of a body of revolution (r, z) of which lambda times the change of volume is a given
/// pressure: u = curl of (r^2 sin(2 r + z) / r) + (0, sin(3 r) cos(z)) / lambda.
struct RevolvedExact
{
  double lambda;

  Eigen::Vector2d displacement(const double r, const double z) const
  {
    const double s = std::sin(2 * r + z), c = std::cos(2 * r + z);
    return {-r * c, 2 * s + 2 * r * c + std::sin(3 * r) * std::cos(z) / lambda};
  }
  double volume_stress(const double r, const double z) const { return -std::sin(3 * r) * std::sin(z); }
  Strain strain(const double r, const double z) const
  {
    const double s = std::sin(2 * r + z), c = std::cos(2 * r + z);
    Strain strain;
    strain[0][0] = -c + 2 * r * s;
    strain[1][1] = -c;
    strain[2][2] = 2 * c - 2 * r * s + volume_stress(r, z) / lambda;
    strain[0][2] = (r * s + 6 * c - 4 * r * s + 3 * std::cos(3 * r) * std::cos(z) / lambda) / 2;
    return strain;
  }
};

/// n x n trapezoids that stay trapezoids, however small they are: 1 < r < 2, 0 < z < 1.
dealii::Triangulation<2> trapezoids(const unsigned int n)
{
  dealii::Triangulation<2> mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {n, n}, {1, 0}, {2, 1});
  const double h = 1. / n;
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int i : cell->vertex_indices())
    {
      const auto column = std::lround((cell->vertex(i)[0] - 1) / h);
      const double row = cell->vertex(i)[1] / h;
      const bool is_inner = row > 0.5 && row < n - 0.5 && std::abs(row - std::round(row)) < 0.1;
      if (is_inner && std::lround(row) % 2 == 1)
        cell->vertex(i)[1] += (column % 2 == 0 ? 0.25 : -0.25) * h;
    }
  return mesh;
}

/// Forces of a stress, so that the exact displacement is in equilibrium.
VectorXd revolved_forces(const SectionDiscretization &space, const RevolvedExact &exact, const double mu)
{
  constexpr unsigned int n_points = 6;
  dealii::FEValues<2> values(space.mapping(), space.scalar_fe(), dealii::QGauss<2>(n_points),
                             dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                                 dealii::update_quadrature_points);
  VectorXd forces = VectorXd::Zero(space.n_dofs());
  std::vector<dealii::types::global_dof_index> dofs(space.fe().n_dofs_per_cell());
  for (const auto &cell : space.dof_handler().active_cell_iterators())
  {
    values.reinit(typename dealii::Triangulation<2>::active_cell_iterator(cell));
    cell->get_dof_indices(dofs);
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const double r = values.quadrature_point(q)[0], z = values.quadrature_point(q)[1];
      const Stress stress =
          2 * mu * exact.strain(r, z) + exact.volume_stress(r, z) * dealii::unit_symmetric_tensor<3>();
      for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const auto [component, node] = space.fe().system_to_component_index(i);
        const auto gradient = values.shape_grad(node, q);
        const double work = component == 0 ? stress[0][0] * gradient[0] + stress[0][2] * gradient[1] +
                                                 stress[1][1] * values.shape_value(node, q) / r
                                           : stress[0][2] * gradient[0] + stress[2][2] * gradient[1];
        forces[space.local_dof(dofs[i])] += 2 * pi * r * values.JxW(q) * work;
      }
    }
  }
  return forces;
}

/// Largest error of the displacement where it is given on the boundary.
double displacement_error(const unsigned int degree, const unsigned int n)
{
  const auto mesh = trapezoids(n);
  const SectionDiscretization space(mesh, projected_mesh(degree), TopFace::guided);
  const LameParameters lame(nearly_incompressible());
  const RevolvedExact exact{lame.lambda};
  VectorXd displacement(space.n_dofs());
  std::vector<unsigned int> inner;
  for (unsigned int dof = 0; dof < space.n_dofs(); ++dof)
  {
    const double r = space.position(dof)[0], z = space.position(dof)[2];
    displacement[dof] = exact.displacement(r, z)[space.direction(dof) == 0 ? 0 : 1];
    if (std::min({r - 1, 2 - r, z, 1 - z}) > 1e-9)
      inner.push_back(dof);
  }
  const Stiffness stiffness(space, Material(nearly_incompressible()));
  MatrixXd matrix(space.n_dofs(), space.n_dofs());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    matrix.col(i) = stiffness.vmult(VectorXd::Unit(matrix.rows(), i));
  const VectorXd lacking = revolved_forces(space, exact, lame.mu) - matrix * displacement;
  return matrix(inner, inner).llt().solve(lacking(inner)).norm() / std::sqrt(double(inner.size()));
}

/// Ratio of the largest to the smallest eigenvalue of the compliance of a contact surface that sticks all
/// over.
double stuck_condition(const double poisson)
{
  MeshOptions options = projected_mesh(2);
  options.core_cells = 4;
  options.rings = 2;
  options.layers = 2;
  MaterialOptions material;
  material.poisson_ratio = poisson;
  const LoadableBody body(GeometryOptions(), options, material, SymmetryPlanes());
  const VectorXd values =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(*body.condensed.compliance().dense(), Eigen::EigenvaluesOnly)
          .eigenvalues();
  return values[values.size() - 1] / values[0];
}
} // namespace

// Pressures in the coordinates of the unit cell lose an order here.
TEST(VolumetricQuadrature, KeepsTheOrderInTrapezoids)
{
  EXPECT_GT(std::log2(displacement_error(2, 4) / displacement_error(2, 8)), 2.8);
  EXPECT_GT(std::log2(displacement_error(3, 4) / displacement_error(3, 8)), 3.8);
}

// A pair that is not stable loses this bound in proportion to lambda: by a factor of 1666 here.
TEST(VolumetricQuadrature, KeepsStuckContactWellConditioned)
{
  EXPECT_LT(stuck_condition(0.4999), 1.5 * stuck_condition(0.3));
}
} // namespace orthocone::test
