// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <orthocone/body/materials/orthotropic_law.h>
#include <orthocone/scene/half_space_obstacle.h>

#include <random>

namespace orthocone::test
{
namespace
{
/// The same elasticity in the words of the orthotropic law, with entries of the isotropic one that mean
/// nothing.
MaterialOptions in_nine_constants(const MaterialOptions &isotropic, std::mt19937 &random)
{
  std::uniform_real_distribution<double> unused(0.1, 0.45);
  const double modulus = isotropic.young_modulus, nu = isotropic.poisson_ratio;
  MaterialOptions material;
  auto &law = material.law.choose<OrthotropicLaw>();
  law.young_moduli.fill(modulus);
  law.poisson_ratios.fill(nu);
  law.shear_moduli.fill(modulus / (2 * (1 + nu)));
  material.young_modulus = 1e6 * unused(random);
  material.poisson_ratio = unused(random);
  return material;
}

/// A scene at random that is pressed, sheared and partly released, and wears.
Parameters random_scene(std::mt19937 &random, const ObstacleKind kind, const char *const wear)
{
  std::uniform_real_distribution<double> one(0, 1);
  Parameters parameters = full_scene(1 + random() % 2);
  parameters.material = {50000 + 200000 * one(random), 0.45 * one(random)};
  parameters.friction.mu = {{0.05 + 0.1 * one(random), 0.05 + 0.1 * one(random)}};
  const MaterialOptions below{50000 + 200000 * one(random), 0.45 * one(random)};
  parameters.obstacle.kind.choose<HalfSpaceKind>().half_space = below;
  parameters.obstacle.kind = kind;
  parameters.lower = {parameters.geometry, parameters.mesh, below};
  parameters.lower.geometry.height = 5 + 10 * one(random);
  parameters.obstacle.gap = random() % 2 == 0 ? "0" : "(x^2+y^2)/2000";
  parameters.wear.law = wear;
  parameters.wear.coefficient = 1e-5;
  parameters.load.legs = {move_to(0, 0, -0.08, 2), move_to(0.06 + 0.04 * one(random), 0.02, -0.08, 3),
                          move_to(0, 0, -0.02 * one(random), 3)};
  return parameters;
}

std::vector<double> values(const Totals &totals)
{
  return {totals.force[0],       totals.force[1],
          totals.force[2],       totals.max_slip,
          totals.stick_area,     totals.total_dissipation,
          totals.elastic_energy, totals.worn_volume,
          totals.max_pressure,   totals.max_accumulated_slip,
          totals.contact_area,   totals.max_wear_depth,
          1. * totals.n_stick,   1. * totals.n_slip};
}

std::vector<std::vector<double>> history(const Parameters &parameters)
{
  std::vector<std::vector<double>> rows;
  TestScene scene(parameters);
  scene.march([&](const ContactState &, const ContactState &after, const LoadStep &)
              { rows.push_back(values(compute_totals(scene.evaluator, after))); });
  return rows;
}
/// Every column of every step, relative to what it comes to on the way.
void expect_same(const std::vector<std::vector<double>> &found,
                 const std::vector<std::vector<double>> &expected, const std::string_view obstacle)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t column = 0; column < expected[0].size(); ++column)
  {
    double scale = 0;
    for (const auto &row : expected)
      scale = std::max(scale, std::abs(row[column]));
    for (std::size_t step = 0; step < found.size(); ++step)
      EXPECT_NEAR(found[step][column], expected[step][column], 1e-9 * scale)
          << obstacle << ", step " << step + 1 << ", column " << column;
    EXPECT_TRUE(scale > 0 || column == 7 || column == 11) << "column " << column; // no wear
  }
}
} // namespace

TEST(Orthotropic, WithIsotropicConstantsIsIsotropicInEveryScene)
{
  std::mt19937 random(11);
  for (const ObstacleKind kind : {ObstacleKind::rigid, ObstacleKind::half_space, ObstacleKind::body})
    for (const char *const wear : {"none", "archard"})
    {
      const Parameters parameters = random_scene(random, kind, wear);
      Parameters other = parameters;
      other.material = in_nine_constants(parameters.material, random);
      other.lower.material = in_nine_constants(parameters.lower.material, random);
      const auto expected = history(parameters), found = history(other);
      expect_same(found, expected, kind.word);
    }
}
} // namespace orthocone::test
