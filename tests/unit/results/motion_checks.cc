// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <orthocone/results/motion_checks.h>

namespace orthocone::test
{
namespace
{
/// The checks of the last step of a scene.
StepChecks checks_of(const Parameters &parameters)
{
  TestScene scene(parameters);
  StepChecker checker(scene.scene, parameters.checks, 1e-10);
  StepChecks checks;
  scene.march(
      [&](const ContactState &before, const ContactState &after, const LoadStep &)
      {
        checks = checker.check({before, compute_totals(scene.evaluator, before)},
                               {after, compute_totals(scene.evaluator, after)}, SolverReport{}, 0);
      });
  EXPECT_EQ(checker.violation(checks).has_value(), violation(checks.motion).has_value());
  return checks;
}

/// A frictionless box 10 mm high under a load along z (N), which is strained alike everywhere.
Parameters box_under(const double load)
{
  Parameters parameters = small_scene();
  parameters.geometry.shape = BodyShape::box;
  parameters.mesh.cells = {{2, 2, 2}};
  parameters.material.poisson_ratio = 0;
  parameters.friction.mu = {{0, 0}};
  Leg leg;
  leg.targets[2] = Drive{true, load};
  parameters.load.legs = {leg};
  return parameters;
}

/// A box on one like it that is pressed and slid along x by so much (mm).
Parameters slid(const double way, const double length_of_lower)
{
  Parameters parameters = small_scene();
  parameters.geometry.shape = BodyShape::box;
  parameters.geometry.sizes = {{4, 4, 4}};
  parameters.mesh.cells = {{4, 4, 2}};
  parameters.obstacle.kind = ObstacleKind::body;
  parameters.lower = {parameters.geometry, parameters.mesh, parameters.material};
  parameters.lower.geometry.sizes[0] = length_of_lower;
  parameters.lower.mesh.cells[0] = static_cast<unsigned int>(length_of_lower);
  parameters.load.legs = {move_to(0, 0, -0.004, 1), move_to(way, 0, -0.004, 1)};
  return parameters;
}
} // namespace

TEST(MotionChecks, KnowTheStrainWhateverDrivesTheBody)
{
  const Parameters unloaded = box_under(0);
  const double stiffness = unloaded.geometry.sizes[0] * unloaded.geometry.sizes[1] *
                           unloaded.material.young_modulus; // N per unit of strain
  for (const double strain : {0.001, 0.2})
  {
    const StepChecks by_force = checks_of(box_under(-strain * stiffness));
    EXPECT_NEAR(by_force.motion.flattening / strain, 1, 1e-9);
    EXPECT_NEAR(by_force.motion.pressure_of_modulus / strain, 1, 1e-9);
    EXPECT_FALSE(violation(by_force.motion));
    Parameters by_gap = unloaded;
    by_gap.obstacle.gap = std::to_string(-10 * strain);
    by_gap.load.legs = {move_to(0, 0, 0, 1)};
    by_gap.geometry.sizes[2] = 10;
    EXPECT_NEAR(checks_of(by_gap).motion.flattening / strain, 1, 1e-9);
  }
}

// Neither the force nor the gap is impossible by itself.
TEST(MotionChecks, RefuseABodyThatIsFlattenedToNothing)
{
  Parameters by_gap = box_under(0);
  by_gap.obstacle.gap = "-20";
  by_gap.load.legs = {move_to(0, 0, 0, 1)};
  EXPECT_TRUE(violation(checks_of(by_gap).motion));
  EXPECT_TRUE(violation(checks_of(box_under(-1e30)).motion));
}

TEST(MotionChecks, KnowHowFarABodySlidesOnAnother)
{
  const StepChecks still = checks_of(slid(0, 4)), within = checks_of(slid(3, 12)),
                   off = checks_of(slid(3, 4));
  EXPECT_LT(still.motion.slide_of_face, 0.1);
  EXPECT_NEAR(within.motion.slide_of_face, 3, 0.1);
  EXPECT_NEAR(within.motion.cover, 1, 1e-3); // pressed sideways, it is a little wider
  EXPECT_FALSE(violation(within.motion));
  EXPECT_NEAR(off.motion.cover, 0.25, 0.01);
  EXPECT_TRUE(violation(off.motion));
}
} // namespace orthocone::test
