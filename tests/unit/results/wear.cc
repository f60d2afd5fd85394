// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "results/scenes.h"

#include <orthocone/results/wear_jumps.h>
#include <orthocone/scene/half_space_obstacle.h>

namespace orthocone::test
{
namespace
{
/// A flat punch, nu = 0, without friction: pressed by a force and dragged.
Parameters dragged_block()
{
  Parameters parameters;
  parameters.geometry.shape = BodyShape::box;
  parameters.mesh.cells = {{4, 4, 2}};
  parameters.mesh.degree = 1;
  parameters.material.poisson_ratio = 0;
  parameters.friction.mu = {{0, 0}};
  parameters.contact_solver.tolerance = 1e-12;
  parameters.wear = {"archard", 1e-6, DeepWear::implicitly, 0};
  Leg press, drag;
  press.targets[2] = Drive{true, -4000};
  drag.targets[0] = Drive{false, 1};
  drag.steps = 10;
  parameters.load.preload = {press};
  parameters.load.legs = {drag};
  return parameters;
}

/// The small scene on an obstacle, with a lower body of other cells. It is five times as stiff as the
/// upper one, for like bodies do not slip.
Parameters worn_by_energy(const ObstacleKind obstacle)
{
  Parameters parameters = small_scene();
  parameters.wear = {"energy", 1e-7, DeepWear::implicitly, 0};
  parameters.mesh.model = ModelKind::quarter;
  parameters.obstacle.kind.choose<HalfSpaceKind>().half_space = {420000, 0.2};
  parameters.obstacle.kind = obstacle;
  parameters.lower = {parameters.geometry, parameters.mesh, parameters.material};
  parameters.lower.mesh.rings = 4;
  parameters.lower.material.young_modulus *= 5;
  return parameters;
}
} // namespace

// Archard: depth = coefficient x pressure x way, at every node.
TEST(Wear, APunchInGrossSlidingWearsEvenly)
{
  TestScene scene(dragged_block());
  scene.march();
  const double depth = 1e-6 * 4000 / (20 * 20) * 1;
  for (Eigen::Index node = 0; node < scene.state.n_nodes(); ++node)
    EXPECT_NEAR(scene.state.wear_depth[node] / depth, 1, 1e-7);
  EXPECT_NEAR(scene.totals().worn_volume / (depth * 20 * 20), 1, 1e-9);
  EXPECT_NEAR(scene.totals().max_wear_depth / depth, 1, 1e-7);
}

// Under a given force the body follows the surface that wears: the pressure stays, the top goes down.
TEST(Wear, TheBodyFollowsTheWornSurface)
{
  TestScene scene(dragged_block());
  double first = 0;
  scene.march(
      [&](const ContactState &, const ContactState &after, const LoadStep &step)
      {
        if (step.number == 1)
          first = after.motion[2];
      });
  const double found = scene.state.found_depth.maxCoeff();
  EXPECT_NEAR((first - scene.state.motion[2]) / found, 1, 1e-7);
  EXPECT_NEAR(found / scene.state.wear_depth.maxCoeff(), 0.9,
              1e-7); // the wear of the last step is for the next
}

// The energy law: worn volume = coefficient x dissipated energy, whatever part of the body is modelled, and
// whatever it slips on.
TEST(Wear, WornVolumeIsTheCoefficientTimesTheDissipatedEnergy)
{
  for (const ObstacleKind obstacle : {ObstacleKind::rigid, ObstacleKind::half_space, ObstacleKind::body})
    for (const ModelKind model : {ModelKind::full, ModelKind::quarter})
    {
      TestScene scene(with_model(worn_by_energy(obstacle), model));
      scene.march();
      EXPECT_GT(scene.totals().total_dissipation, 100);
      EXPECT_NEAR(scene.totals().worn_volume / (1e-7 * scene.totals().total_dissipation), 1, 1e-12);
    }
}

// A counterface a hundred million times stiffer is the rigid one: the same depths at every node.
TEST(Wear, StiffCounterfacesWearTheBodyAsAPlaneDoes)
{
  TestScene rigid(worn_by_energy(ObstacleKind::rigid));
  rigid.march();
  for (const ObstacleKind obstacle : {ObstacleKind::half_space, ObstacleKind::body})
  {
    Parameters parameters = worn_by_energy(obstacle);
    parameters.obstacle.kind.choose<HalfSpaceKind>().half_space.young_modulus *= 1e8;
    parameters.obstacle.kind = obstacle;
    parameters.lower.material.young_modulus *= 1e8;
    TestScene stiff(parameters);
    stiff.march();
    EXPECT_LE(largest_difference(stiff.state.wear_depth, rigid.state.wear_depth), 1e-6);
  }
}

TEST(Wear, PartsOfTheBodyWearLikeAllOfIt)
{
  Parameters parameters = small_scene();
  parameters.wear = {"archard", 1e-5, DeepWear::implicitly, 0};
  parameters.load.legs = {move_to(0, 0, -0.1, 4), move_to(0, 0, -0.05, 3)};
  TestScene quarter(parameters);
  quarter.march();
  parameters.mesh.model = ModelKind::full;
  TestScene full(parameters);
  full.march();
  expect_same_fields(quarter, full, 1e-7);
  EXPECT_NEAR(quarter.totals().worn_volume / full.totals().worn_volume, 1, 1e-8);
  EXPECT_NEAR(quarter.totals().max_wear_depth / full.totals().max_wear_depth, 1, 1e-8);
}

// A body that wears less the deeper it is worn, h' = rate / (1 + h): jumps obey the largest depth, come near
// the closed form (1 + h)^2 = 1 + 2 rate n, nearer the shorter they are, and bound what they err by.
TEST(WearJumps, ErrByLessThanTheyEstimate)
{
  constexpr double rate = 1e-3;
  constexpr unsigned int n_cycles = 4000;
  const double exact = std::sqrt(1 + 2 * rate * n_cycles) - 1;
  double last_error = 1;
  for (const double largest : {0.2, 0.05, 0.0125})
  {
    WearJumps jumps({"archard", 1, DeepWear::implicitly, largest}, Eigen::VectorXd::Constant(1, 2.));
    ContactState state(1);
    unsigned int n_computed = 0;
    for (unsigned int cycle = 1; cycle <= n_cycles; ++cycle, ++n_computed)
    {
      const ContactState start = state;
      state.wear_depth[0] += rate / (1 + state.wear_depth[0]);
      const unsigned int n = jumps.after_cycle(start, state, n_cycles - cycle);
      const double depth = n * (state.wear_depth[0] - start.wear_depth[0]);
      EXPECT_LE(depth, largest);
      state.wear_depth[0] += depth;
      cycle += n;
    }
    const double error = state.wear_depth[0] - exact;
    EXPECT_GT(error, 0); // each jump goes on at the rate of its beginning
    // Errors of the volume, on an area of 2. What is worn too deep wears less later: the sum of all jumps is
    // a bound.
    EXPECT_GE(-jumps.memory().error / (2 * error), 1) << largest;
    EXPECT_LE(-jumps.memory().error / (2 * error), 2) << largest;
    EXPECT_LT(error, 0.5 * last_error);
    EXPECT_LT(n_computed, n_cycles / 4);
    last_error = error;
  }
}

// Where jumps make contact flicker, the rate changes without end: they get shorter until it does not.
TEST(WearJumps, GetShorterWhereTheRateFlickers)
{
  WearJumps jumps({"archard", 1, DeepWear::implicitly, 1.}, Eigen::VectorXd::Ones(1));
  ContactState state(1);
  unsigned int longest = 0, last = 0;
  for (unsigned int cycle = 0; cycle < 40; ++cycle)
  {
    const ContactState start = state;
    state.wear_depth[0] += cycle / 2 % 2 == 0 ? 1e-3 : 1e-4;
    if (const unsigned int n = jumps.after_cycle(start, state, 1000000))
    {
      longest = std::max(longest, n);
      last = n;
    }
  }
  EXPECT_GT(longest, 100u);
  EXPECT_EQ(last, 1u);
}

TEST(WearJumps, AreNotMadeUnasked)
{
  WearJumps none({"archard", 1, DeepWear::implicitly, 0}, Eigen::VectorXd::Ones(1));
  const ContactState start(1);
  ContactState end(1);
  end.wear_depth[0] = 1e-9;
  for (unsigned int cycle = 0; cycle < 5; ++cycle)
    EXPECT_EQ(none.after_cycle(start, end, 100), 0u);
}
} // namespace orthocone::test
