// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "refined_body.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::VectorXd;

namespace
{
void expect_products_of_the_matrix(const GeometryOptions &geometry, const MeshOptions &mesh)
{
  const LoadableBody body(geometry, mesh, default_material, quarter);
  const MatrixFreeStiffness<double> stiffness(body.discretization, default_material);
  const VectorXd u = random_numbers(body.discretization.n_free(), mesh.degree);
  BodyVector<double> displacement = stiffness.make_vector(), forces = displacement;
  std::copy(u.begin(), u.end(), displacement.begin());
  stiffness.vmult(forces, displacement);
  const VectorXd expected = body.stiffness.vmult(u);
  for (unsigned int dof = 0; dof < body.discretization.n_dofs(); ++dof)
    EXPECT_NEAR(forces.local_element(dof), dof < expected.size() ? expected[dof] : 0,
                1e-13 * expected.norm());
}
} // namespace

TEST(MatrixFreeStiffness, MultipliesAsTheAssembledOne)
{
  for (const BodyShape shape : {BodyShape::cylinder, BodyShape::box})
    for (const auto &[degree, n_points] : {std::pair{1U, 2U}, {2U, 3U}, {3U, 4U}, {1U, 3U}, {2U, 5U}})
      for (const auto quadrature : {VolumetricQuadrature::full, VolumetricQuadrature::projected})
      {
        MeshOptions mesh = even_mesh(degree, 0);
        mesh.quadrature_points = n_points;
        mesh.volumetric_quadrature = quadrature;
        expect_products_of_the_matrix(shape_of(shape), mesh);
      }
}

TEST(MatrixFreeStiffness, KnowsItsDiagonal)
{
  for (const auto quadrature : {VolumetricQuadrature::full, VolumetricQuadrature::projected})
  {
    MeshOptions mesh = even_mesh(2, 0);
    mesh.volumetric_quadrature = quadrature;
    const LoadableBody body(default_geometry, mesh, default_material, quarter);
    const BodyVector<float> diagonal =
        MatrixFreeStiffness<float>(body.discretization, default_material).diagonal();
    for (unsigned int dof = 0; dof < body.discretization.n_dofs(); ++dof)
    {
      const double expected = dof < body.discretization.n_free() ? body.stiffness.matrix()(dof, dof) : 0;
      EXPECT_NEAR(diagonal.local_element(dof), expected, 1e-5 * expected);
    }
  }
}
} // namespace orthocone::test
