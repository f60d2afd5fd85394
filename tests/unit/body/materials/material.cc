// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/materials/material.h>

#include <orthocone/body/materials/orthotropic_law.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

namespace orthocone::test
{
// Hooke's law in the words of its two constants: E along the axis of a rod, -nu across.
TEST(Material, HasYoungsModulusAndPoissonsRatio)
{
  MaterialOptions options;
  options.young_modulus = 1000;
  options.poisson_ratio = 0.3;
  const Material material(options);
  Strain rod;
  rod[0][0] = 0.01;
  rod[1][1] = rod[2][2] = -0.003;
  const Stress stress = material.stress(rod);
  EXPECT_NEAR(stress[0][0], 10, 1e-12);
  EXPECT_NEAR(stress[1][1], 0, 1e-12);
  EXPECT_NEAR(stress[2][2], 0, 1e-12);
}

TEST(Material, HasTheTangentOfItsStress)
{
  const Material material((MaterialOptions()));
  Strain strain;
  strain[0][0] = 0.1;
  strain[1][2] = -0.3;
  strain[2][2] = 0.2;
  const Stress stress = material.stress(strain);
  EXPECT_LE((material.tangent() * strain - stress).norm(), 1e-14 * stress.norm());
  const Stress rest = material.stress(strain, 0);
  EXPECT_LE((material.tangent_at_constant_volume() * strain - rest).norm(), 1e-14 * rest.norm());
  EXPECT_NEAR(stress[0][0] - rest[0][0], material.volumetric_modulus() * trace(strain), 1e-9);
}

// The volumetric part is that of the isotropic material of the same constants, and what is left over stores
// energy.
TEST(Material, HasAVolumetricPartWhateverItsLaw)
{
  MaterialOptions options;
  auto &law = options.law.choose<OrthotropicLaw>();
  for (const double poisson : {-0.5, 0.3, 0.4999})
  {
    MaterialOptions isotropic;
    isotropic.poisson_ratio = poisson;
    const double shear = isotropic.young_modulus / (2 * (1 + poisson));
    law.young_moduli.fill(isotropic.young_modulus);
    law.poisson_ratios.fill(poisson);
    law.shear_moduli.fill(shear);
    const ElasticTangent expected = Material(isotropic).tangent_at_constant_volume();
    const ElasticTangent change = Material(options).tangent_at_constant_volume() - expected;
    EXPECT_LE(change.norm(), 1e-10 * expected.norm() / (0.5 - poisson));
  }
  law.young_moduli = {{100, 50, 2000}};
  law.poisson_ratios = {{0.3, 0.05, 0.01}};
  law.shear_moduli = {{11, 1200, 13}};
  const Material material(options);
  Eigen::Matrix3d normal;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      normal(i, j) = material.tangent_at_constant_volume()[i][i][j][j];
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normal).eigenvalues().minCoeff(), 0);
  Strain strain;
  strain[0][0] = 0.1;
  strain[1][2] = 0.2;
  EXPECT_LE((material.stress(strain, trace(strain)) - material.stress(strain)).norm(), 1e-12);
  EXPECT_LE((material.stress(strain, 0) - material.tangent_at_constant_volume() * strain).norm(), 1e-12);
}

// Each column of the compliance is the strain under one stress.
TEST(Material, IsOrthotropic)
{
  MaterialOptions options;
  auto &law = options.law.choose<OrthotropicLaw>();
  law.young_moduli = {{100, 50, 20}};
  law.poisson_ratios = {{0.3, 0.2, 0.4}};
  law.shear_moduli = {{11, 12, 13}};
  const Material material(options);
  Strain along_x;
  along_x[0][0] = 0.01;
  along_x[1][1] = -0.003;
  along_x[2][2] = -0.002;
  Strain along_z;
  along_z[2][2] = 0.01;
  along_z[0][0] = -0.2 / 100 * 20 * 0.01;
  along_z[1][1] = -0.4 / 50 * 20 * 0.01;
  Strain shear;
  shear[0][1] = 0.01;
  shear[1][2] = 0.02;
  Stress expected;
  expected[0][0] = 1;
  EXPECT_LE((material.stress(along_x) - expected).norm(), 1e-13);
  expected.clear();
  expected[2][2] = 0.2;
  EXPECT_LE((material.stress(along_z) - expected).norm(), 1e-13);
  expected.clear();
  expected[0][1] = 2 * 11 * 0.01;
  expected[1][2] = 2 * 13 * 0.02;
  EXPECT_LE((material.stress(shear) - expected).norm(), 1e-13);
  EXPECT_LE((material.tangent() * shear - expected).norm(), 1e-13);
}
} // namespace orthocone::test
