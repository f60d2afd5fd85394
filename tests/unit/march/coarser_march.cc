// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/coarser_march.h>

#include "body/even_mesh.h"

#include <gtest/gtest.h>

namespace orthocone::test
{
using Eigen::VectorXd;

namespace
{
/// Case B's friction on cells that are nearly cubes.
Parameters refined(const unsigned int refinements)
{
  Parameters parameters;
  parameters.mesh = even_mesh(2, refinements);
  parameters.mesh.backend = BodyBackend::multigrid;
  parameters.load.legs = {move_to(0, 0, -0.1, 2), move_to(0, 0, -0.05, 2)};
  return parameters;
}
} // namespace

TEST(CoarserMarch, IsThereForRefinedBodiesWithMultigrid)
{
  const Parameters none = refined(0);
  Parameters condensed = refined(1);
  condensed.mesh.backend = BodyBackend::condensed;
  for (const Parameters &parameters : {none, condensed})
    EXPECT_EQ(CoarserMarch::of(Scene(parameters, choose_model(parameters))), nullptr);
  EXPECT_NE(CoarserMarch::of(Scene(refined(1), choose_model(refined(1)))), nullptr);
}

/// What a step changes on the coarser mesh is close to what it changes on the finer one, step by step.
TEST(CoarserMarch, IsCloseToTheFinerOne)
{
  Parameters uneven = refined(1);
  uneven.mesh.refined_cells = {{{0, 8}}, {{3, 5}, {9, 30}}};
  for (const Parameters &parameters : {refined(1), uneven})
  {
    const Scene scene(parameters, choose_model(parameters));
    StepSolver solver(scene);
    ContactState state(scene.gaps());
    const auto coarser = CoarserMarch::of(scene);
    for (const LoadStep &step : LoadProgram(parameters.load).steps())
    {
      ContactState next = state;
      ASSERT_TRUE(solver.solve(next, step).converged);
      const auto change = coarser->solve(step);
      ASSERT_TRUE(change.has_value());
      const VectorXd fine =
          scene.body().elastic_displacement(next.force) - scene.body().elastic_displacement(state.force);
      const VectorXd coarse = scene.body().prolonged(change->displacement);
      EXPECT_LE((coarse - fine).norm(), 0.05 * fine.norm()) << step.number;
      EXPECT_EQ(change->motion.components, next.motion.components - state.motion.components);
      solver.accept(state, next, step);
      coarser->accept(step);
      state = next;
    }
  }
}

/// A step that is not accepted leaves no trace.
TEST(CoarserMarch, ForgetsAStepThatIsNotAccepted)
{
  const Parameters parameters = refined(1);
  const Scene scene(parameters, choose_model(parameters));
  const auto steps = LoadProgram(parameters.load).steps();
  const auto coarser = CoarserMarch::of(scene);
  coarser->solve(steps.back());
  EXPECT_EQ(coarser->memory().state.force, CoarserMarch::of(scene)->memory().state.force);
}
} // namespace orthocone::test
