// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The stiffness of sections against that of solids whose displacements are the same along y, and against
// motions that strain nothing.
#include <orthocone/body/fe/stiffness.h>
#include <orthocone/body/materials/material.h>
#include <orthocone/body/materials/orthotropic_law.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

namespace orthocone::test
{
namespace
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double slice_thickness = 1.7;

/// Quadrilaterals in the plane (x, z), none of which is a rectangle. They have no held or contact faces.
void make_quadrilaterals(dealii::Triangulation<2> &mesh)
{
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {3, 2}, dealii::Point<2>(-1, 0),
                                                    dealii::Point<2>(2, 1.5));
  dealii::GridTools::transform(
      [](const dealii::Point<2> &place)
      {
        return dealii::Point<2>(place[0] + 0.15 * place[1] * place[1],
                                place[1] + 0.1 * std::sin(place[0] * (1 + place[1])));
      },
      mesh);
}

/// The same, one cell thick along y.
void make_slice(dealii::Triangulation<3> &mesh)
{
  dealii::Triangulation<2> section;
  make_quadrilaterals(section);
  dealii::GridGenerator::extrude_triangulation(section, 2, slice_thickness, mesh);
  dealii::GridTools::transform([](const dealii::Point<3> &place)
                               { return dealii::Point<3>(place[0], slice_thickness - place[2], place[1]); },
                               mesh);
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(0); // neither held nor in contact
}

/// Ones where a degree of freedom of the slice moves with one of the section: (solid) x (section).
template<typename Solid, typename Section>
MatrixXd extension(const Solid &solid, const Section &section)
{
  using Key = std::tuple<long, long, unsigned int>;
  const auto key = [](const BodyUnknowns &space, const unsigned int dof)
  {
    const Eigen::Vector3d place = space.position(dof);
    return Key(std::lround(1e8 * place[0]), std::lround(1e8 * place[2]), space.direction(dof));
  };
  std::map<Key, Index> numbers;
  for (unsigned int dof = 0; dof < section.n_dofs(); ++dof)
    numbers[key(section, dof)] = dof;
  MatrixXd map = MatrixXd::Zero(solid.n_dofs(), section.n_dofs());
  for (unsigned int dof = 0; dof < solid.n_dofs(); ++dof)
    map(dof, numbers.at(key(solid, dof))) = 1;
  return map;
}

template<int dim>
MatrixXd all_stiffness(const DisplacementSpace<dim> &space, const MaterialOptions &material)
{
  const Stiffness stiffness(space, Materials(Material(material)));
  MatrixXd matrix(space.n_free(), space.n_free());
  for (Index i = 0; i < matrix.cols(); ++i)
    matrix.col(i) = stiffness.vmult(VectorXd::Unit(matrix.rows(), i));
  return matrix;
}

MaterialOptions orthotropic()
{
  MaterialOptions material;
  auto &law = material.law.choose<OrthotropicLaw>();
  law.young_moduli = {{100, 200, 50}};
  law.poisson_ratios = {{0.2, 0.35, 0.3}};
  law.shear_moduli = {{40, 25, 60}};
  return material;
}

MeshOptions mesh_of(const unsigned int degree, const VolumetricQuadrature quadrature)
{
  MeshOptions options;
  options.degree = degree;
  options.volumetric_quadrature = quadrature;
  return options;
}
} // namespace

// A displacement that is the same along y stores the same energy in the slice and in its section.
TEST(PlaneSection, IsTheSolidSliceOfTheSameMesh)
{
  dealii::Triangulation<2> flat;
  dealii::Triangulation<3> slice;
  make_quadrilaterals(flat);
  make_slice(slice);
  for (const unsigned int degree : {1, 2, 3})
    for (const auto quadrature : {VolumetricQuadrature::full, VolumetricQuadrature::projected})
      for (const MaterialOptions &material : {MaterialOptions(), orthotropic()})
      {
        const MeshOptions options = mesh_of(degree, quadrature);
        const SectionDiscretization section(flat, options, TopFace::clamped,
                                            {SectionModel::Kind::plane, true, slice_thickness});
        const Discretization solid(slice, options, TopFace::clamped);
        const MatrixXd map = extension(solid, section);
        const MatrixXd of_section = all_stiffness(section, material);
        const MatrixXd moved = all_stiffness(solid, material) * map, across = map.transpose();
        const MatrixXd of_slice = across * moved;
        EXPECT_LE((of_section - of_slice).norm(), 1e-13 * of_slice.norm()) << "degree " << degree;
      }
}

TEST(PlaneSection, HasTwoBlocks)
{
  dealii::Triangulation<2> flat;
  make_quadrilaterals(flat);
  const SectionDiscretization section(flat, mesh_of(2, VolumetricQuadrature::projected), TopFace::clamped,
                                      {SectionModel::Kind::plane, true, slice_thickness});
  const MatrixXd stiffness = all_stiffness(section, orthotropic());
  for (unsigned int i = 0; i < section.n_dofs(); ++i)
    for (unsigned int j = 0; j < section.n_dofs(); ++j)
      if ((section.direction(i) == 1) != (section.direction(j) == 1))
      {
        EXPECT_EQ(stiffness(i, j), 0);
      }
}

// The twist u_theta = r is a rotation about the axis. Left alone, the section has it and u_z = 1 for nothing,
// and nothing else.
TEST(TwistedSection, RotatesAboutItsAxisForNothing)
{
  dealii::Triangulation<2> mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {3, 2}, dealii::Point<2>(0, 0),
                                                    dealii::Point<2>(2, 1.5));
  for (const unsigned int degree : {1, 2, 3, 4})
  {
    const SectionDiscretization section(mesh, mesh_of(degree, VolumetricQuadrature::full), TopFace::clamped,
                                        {SectionModel::Kind::revolved, true});
    const MatrixXd stiffness = all_stiffness(section, {});
    VectorXd rotation = VectorXd::Zero(stiffness.rows()), translation = rotation;
    for (unsigned int dof = 0; dof < section.n_dofs(); ++dof)
    {
      if (section.direction(dof) == 1)
        rotation[dof] = section.position(dof)[0];
      if (section.direction(dof) == 2)
        translation[dof] = 1;
    }
    EXPECT_LE((stiffness * rotation).norm(), 1e-13 * stiffness.norm() * rotation.norm());
    EXPECT_LE((stiffness * translation).norm(), 1e-13 * stiffness.norm() * translation.norm());
    const VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(stiffness).eigenvalues();
    EXPECT_LE(std::abs(values[1]), 1e-12 * values.maxCoeff());
    EXPECT_GE(values[2], 1e-7 * values.maxCoeff());
  }
}
} // namespace orthocone::test
