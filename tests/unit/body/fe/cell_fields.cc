// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "body/bodies.h"

#include <orthocone/body/fe/cell_fields.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

namespace orthocone::test
{
namespace
{
MeshOptions mesh_with(const unsigned int degree, const VolumetricQuadrature quadrature)
{
  MeshOptions mesh = small_mesh(degree);
  mesh.volumetric_quadrature = quadrature;
  return mesh;
}

/// A displacement that is linear in the place has this stress everywhere, and moves every point as it should.
template<int dim>
void expect_uniform(const DisplacementSpace<dim> &space, const Eigen::Matrix3d &gradient)
{
  Eigen::VectorXd displacement(space.n_dofs());
  for (unsigned int dof = 0; dof < space.n_dofs(); ++dof)
    displacement[dof] = (gradient * space.position(dof))[space.direction(dof)];
  Strain strain;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      strain[i][j] = (gradient(i, j) + gradient(j, i)) / 2;
  const Stress expected = stress_of(strain, LameParameters(default_material));
  CellFields<dim> fields(space, Material(default_material),
                         dealii::QIterated<dim>(dealii::QTrapezoid<1>(), 2), displacement);
  for (const auto &cell : space.dof_handler().active_cell_iterators())
    for (const PointFields &point : fields.in(cell))
    {
      EXPECT_LE((point.stress - expected).norm(), 1e-9 * expected.norm());
      EXPECT_LE((point.displacement - gradient * point.place).norm(), 1e-12);
    }
}

const std::array<VolumetricQuadrature, 2> quadratures{
    {VolumetricQuadrature::full, VolumetricQuadrature::projected}};
} // namespace

TEST(CellFields, AreUniformWhereTheSolidIsStrainedUniformly)
{
  Eigen::Matrix3d gradient;
  gradient << 1e-3, 2e-3, -1e-3, 0.5e-3, -2e-3, 3e-3, 0.7e-3, -0.2e-3, 1.5e-3;
  for (const VolumetricQuadrature quadrature : quadratures)
    for (const unsigned int degree : {1, 2, 3})
    {
      const MeshOptions options = mesh_with(degree, quadrature);
      const BodyMesh mesh({}, options, SymmetryPlanes{});
      expect_uniform(Discretization(mesh.triangulation(), options, TopFace::clamped), gradient);
    }
}

// On the axis the hoop strain is a limit.
TEST(CellFields, AreUniformWhereTheSectionIsStrainedUniformly)
{
  const Eigen::Matrix3d gradient = Eigen::Vector3d(1e-3, 1e-3, -2e-3).asDiagonal();
  for (const VolumetricQuadrature quadrature : quadratures)
    for (const unsigned int degree : {1, 2, 4})
    {
      const MeshOptions options = mesh_with(degree, quadrature);
      const SectionMesh mesh({}, options);
      expect_uniform(SectionDiscretization(mesh.triangulation(), options, TopFace::clamped), gradient);
    }
}
} // namespace orthocone::test
