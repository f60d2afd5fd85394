// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Mesh/Volumetric quadrature = projected: what it may not spoil (rank, uniform states), and what it is for.
// Its rates are in test_accuracy.cc.
#include "body/bodies.h"

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace orthocone::test
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{
MaterialOptions material_of(const double poisson)
{
  MaterialOptions material;
  material.poisson_ratio = poisson;
  return material;
}

MeshOptions projected(MeshOptions options)
{
  options.volumetric_quadrature = VolumetricQuadrature::projected;
  return options;
}

MeshOptions options_of(const unsigned int degree, const VolumetricQuadrature quadrature)
{
  MeshOptions options;
  options.degree = degree;
  options.volumetric_quadrature = quadrature;
  return options;
}

/// A cube whose degrees of freedom are all free, or a prism with a trapezoid as its base.
dealii::Triangulation<3> one_cell(const bool is_trapezoid)
{
  dealii::Triangulation<3> cell;
  dealii::GridGenerator::hyper_cube(cell);
  if (is_trapezoid)
    cell.begin_active()->vertex(0)[0] = cell.begin_active()->vertex(4)[0] = -1;
  return cell;
}

MatrixXd dense_stiffness(const Discretization &discretization, const MaterialOptions &material)
{
  const Stiffness stiffness(discretization, material);
  MatrixXd matrix(discretization.n_free(), discretization.n_free());
  for (Index i = 0; i < matrix.rows(); ++i)
    matrix.col(i) = stiffness.vmult(VectorXd::Unit(matrix.rows(), i));
  return matrix;
}

VectorXd eigenvalues(const MatrixXd &matrix)
{
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

/// Ways of a cube to deform that its stiffness resists in proportion to lambda: the rank of the derivative.
unsigned int n_volume_constraints(const unsigned int degree, const VolumetricQuadrature quadrature)
{
  const auto cell = one_cell(false);
  const Discretization discretization(cell, options_of(degree, quadrature), TopFace::guided);
  MaterialOptions soft = material_of(0.25); // E chosen for mu = 1 in both
  soft.young_modulus = 2 * (1 + 0.25);
  MaterialOptions stiff = material_of(0.4);
  stiff.young_modulus = 2 * (1 + 0.4);
  const VectorXd change =
      eigenvalues(dense_stiffness(discretization, stiff) - dense_stiffness(discretization, soft));
  return std::count_if(change.begin(), change.end(),
                       [&](const double value) { return value > 1e-10 * change[change.size() - 1]; });
}

/// Total force on the base where it sticks all over and the clamped top comes down by 0.1 mm.
double stuck_force(const MeshOptions &options, const double poisson)
{
  const LoadableBody body(GeometryOptions(), options, material_of(poisson), {true, true});
  const NodeVector free = body.condensed.frame().moved_with(moved_by(0, 0, -0.1));
  const NodeVector force = body.condensed.compliance().dense()->llt().solve(-free);
  double total = 0;
  for (Index i = 0; i < force.size(); i += 3)
    total += force[i];
  return total;
}
} // namespace

TEST(VolumetricQuadrature, LeavesRigidMotionsAlone)
{
  constexpr Index n_rigid = 6;
  for (const unsigned int degree : {1, 2, 3})
    for (const double poisson : {-0.9, 0.3, 0.4999})
      for (const bool is_trapezoid : {false, true})
      {
        const auto cell = one_cell(is_trapezoid);
        const Discretization discretization(cell, options_of(degree, VolumetricQuadrature::projected),
                                            TopFace::guided);
        const MaterialOptions material = material_of(poisson);
        const VectorXd values = eigenvalues(dense_stiffness(discretization, material));
        const double rounding = 1e-12 * values[values.size() - 1];
        EXPECT_LT(values.head(n_rigid).lpNorm<Eigen::Infinity>(), rounding);
        EXPECT_GT(values[n_rigid], 1e-3 * material.young_modulus)
            << "degree " << degree << ", Poisson's ratio " << poisson;
      }
}

// A mesh has 3 p^3 degrees of freedom a cell. Where changes of volume are forbidden in more ways than that,
// nothing is left that can move: Q1 locks, and Q2 has nothing to spare. Projected, they are forbidden in as
// many ways as there are complete polynomials of degree p - 1.
TEST(VolumetricQuadrature, ForbidsAsManyChangesOfVolumeAsThereArePolynomials)
{
  const std::array<unsigned int, 3> n_full{{7, 26, 63}}, n_projected{{1, 4, 10}};
  for (const unsigned int degree : {1, 2, 3})
  {
    EXPECT_EQ(n_volume_constraints(degree, VolumetricQuadrature::full), n_full[degree - 1]);
    EXPECT_EQ(n_volume_constraints(degree, VolumetricQuadrature::projected), n_projected[degree - 1]);
  }
}

// The limit is 0.256 MN, where meshes of degree 2 and 3 arrive from above.
TEST(VolumetricQuadrature, FreesTheBodyThatLocks)
{
  MeshOptions options = small_mesh(1);
  options.core_cells = 4;
  options.layers = 4;
  constexpr double poisson = 0.4999;
  MeshOptions fine = options;
  fine.degree = 3;
  const double reference = stuck_force(projected(fine), poisson);
  EXPECT_GT(stuck_force(options, poisson), 20 * reference);
  EXPECT_NEAR(stuck_force(projected(options), poisson), reference, 0.03 * reference);
  constexpr double steel = 0.3;
  EXPECT_NEAR(stuck_force(projected(options), steel), stuck_force(options, steel),
              0.01 * stuck_force(options, steel));
}
} // namespace orthocone::test
