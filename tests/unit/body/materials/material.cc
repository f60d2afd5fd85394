// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/materials/material.h>

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
} // namespace orthocone::test
