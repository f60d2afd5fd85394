// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Friction with memory: Friction/Factor through scenes of all kinds.
#include "results/scenes.h"

#include <orthocone/base/errors.h>
#include <orthocone/scene/half_space_obstacle.h>

namespace orthocone::test
{
namespace
{
constexpr unsigned int about_z = 5;

Parameters with_factor(Parameters parameters, const std::string &text)
{
  parameters.friction.factor = FrictionFactor(text);
  return parameters;
}

/// A shaft of isotropic friction without Poisson's ratio, so that its pressure is even and stays: pressed,
/// and turned in steps until it slides.
Parameters turned_shaft(const unsigned int n_steps)
{
  Parameters parameters = small_scene();
  parameters.mesh.core_cells = parameters.mesh.rings = 2;
  parameters.material.poisson_ratio = 0;
  parameters.friction.mu = {{0.2, 0.2}};
  Leg turn;
  turn.targets[about_z] = Drive{false, 30};
  turn.steps = n_steps;
  parameters.load.preload = {move_to(0, 0, -0.1, 1)};
  parameters.load.legs = {turn};
  return parameters;
}

/// Pressed and dragged on a counterface of another kind.
Parameters dragged_on(const ObstacleKind obstacle)
{
  Parameters parameters = small_scene();
  parameters.load.legs = {move_to(0, 0, -0.1, 2), move_to(0.02, 0.01, -0.1, 3), move_to(0, 0, -0.05, 2)};
  parameters.obstacle.kind.choose<HalfSpaceKind>().half_space = {420000, 0.2};
  parameters.obstacle.kind = obstacle;
  parameters.lower = {parameters.geometry, parameters.mesh, parameters.material};
  return parameters;
}

/// What a node slides dissipates: dw = mu(w) p ds with mu = mu_0 exp(-w/w_0), so that
/// w = w_0 log(1 + mu_0 p s / w_0). Returns the largest error at nodes that slide, relative.
double error_of_decay(const unsigned int n_steps)
{
  constexpr double w_0 = 200, mu_0 = 0.2;
  TestScene scene(with_factor(turned_shaft(n_steps), "exp(-w/200)"));
  scene.march();
  double error = 0;
  unsigned int n_sliding = 0;
  for (unsigned int node = 0; node < scene.state.n_nodes(); ++node)
  {
    const ContactFields fields = scene.evaluator.fields(scene.state, node);
    if (fields.accumulated_slip < 1)
      continue; // near the axis
    const double exact = w_0 * std::log1p(mu_0 * fields.pressure * fields.accumulated_slip / w_0);
    EXPECT_GT(exact, w_0); // friction falls to less than a third
    error = std::max(error, std::abs(fields.dissipated_energy / exact - 1));
    ++n_sliding;
  }
  EXPECT_GT(n_sliding, 2u);
  return error;
}
} // namespace

TEST(FrictionWithMemory, OfAConstantFactorIsThatOfTheOtherCoefficients)
{
  std::vector<Parameters> scenes{small_scene(), turned_shaft(3)};
  for (const ObstacleKind obstacle : {ObstacleKind::rigid, ObstacleKind::half_space, ObstacleKind::body})
    scenes.push_back(dragged_on(obstacle));
  scenes.back().wear = {"energy", 1e-7, DeepWear::implicitly, 0};
  for (const Parameters &parameters : scenes)
  {
    TestScene doubled(with_factor(parameters, "2"));
    doubled.march();
    Parameters other = parameters;
    other.friction.mu = {{2 * parameters.friction.mu[0], 2 * parameters.friction.mu[1]}};
    TestScene given(other);
    given.march();
    EXPECT_EQ(doubled.state.force, given.state.force);
    EXPECT_EQ(doubled.state.displacement, given.state.displacement);
    EXPECT_EQ(doubled.state.dissipated_energy, given.state.dissipated_energy);
    EXPECT_EQ(doubled.state.status, given.state.status);
    EXPECT_EQ(doubled.totals().stick_area, given.totals().stick_area);
    EXPECT_TRUE(doubled.state.friction_factor.isConstant(2, 0));
    EXPECT_FALSE(given.totals().factor);
    EXPECT_EQ(given.state.friction_factor.size(), 0);
  }
}

// The closed form of a node whose friction falls with its work, with an error of first order.
TEST(FrictionWithMemory, FallsAsItsOwnWorkLetsIt)
{
  const double coarse = error_of_decay(10), fine = error_of_decay(20), finest = error_of_decay(40);
  EXPECT_LT(coarse, 0.2);
  EXPECT_NEAR(fine / coarse, 0.5, 0.1);
  EXPECT_NEAR(finest / fine, 0.5, 0.05);
}

TEST(FrictionWithMemory, OfPartsOfTheBodyIsThatOfAllOfIt)
{
  Parameters parameters = with_factor(small_scene(), "(1 + s/0.001)/(1 + w/0.5)*(1 + 0.01*sqrt(p)) + 0.1*n");
  parameters.load.legs = {move_to(0, 0, -0.1, 4), move_to(0, 0, -0.02, 3)};
  parameters.load.cycles = 2;
  TestScene quarter(parameters);
  quarter.march();
  TestScene full(with_model(parameters, ModelKind::full));
  full.march();
  expect_same_fields(quarter, full, 1e-7);
  const FactorRange of_quarter = *quarter.totals().factor, of_full = *full.totals().factor;
  EXPECT_GT(of_full.largest, 1.2 * of_full.least);
  EXPECT_NEAR(of_quarter.least / of_full.least, 1, 1e-8);
  EXPECT_NEAR(of_quarter.mean / of_full.mean, 1, 1e-8);
  EXPECT_NEAR(of_quarter.largest / of_full.largest, 1, 1e-8);
}

// All of the law is that of the step: nodes that slip are on its cone, and the bodies keep their energy.
TEST(FrictionWithMemory, IsThatOfChecksAndFields)
{
  TestScene scene(with_factor(turned_shaft(6), "1/(1 + w/100)"));
  StepChecker checker(scene.scene, scene.parameters.checks, 1e-10);
  scene.march(
      [&](const ContactState &before, const ContactState &after, const LoadStep &)
      {
        const StepChecks checks =
            checker.check({before, compute_totals(scene.evaluator, before)},
                          {after, compute_totals(scene.evaluator, after)}, SolverReport{}, 0);
        EXPECT_LE(checks.energy_identity, 1e-9);
        EXPECT_EQ(checks.change_of_factor, change_of_factor(before, after));
      });
  for (unsigned int node = 0; node < scene.state.n_nodes(); ++node)
    if (scene.state.status[node] == NodeStatus::slip)
    {
      const ContactFields fields = scene.evaluator.fields(scene.state, node);
      EXPECT_NEAR(fields.friction_criterion, 0, 1e-9);
      EXPECT_NEAR(fields.friction_traction.norm(), 0.2 * fields.friction_factor * fields.pressure,
                  1e-9 * fields.pressure);
    }
  EXPECT_LT(scene.totals().factor->least, 0.9);
}

TEST(FrictionWithMemory, ThatIsNoNumberEndsTheMarch)
{
  TestScene scene(with_factor(turned_shaft(10), "1 - s/3"));
  try
  {
    scene.march();
    ADD_FAILURE() << "friction has no coefficients";
  }
  catch (const SolveError &error)
  {
    for (const char *const part : {"Friction/Factor = 1 - s/3 is -", "mm, w = ", " MPa, n = 1", "allowed is"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
  EXPECT_GT(scene.state.step, 1u);
  EXPECT_LT(scene.state.step, 10u);
}
} // namespace orthocone::test
