// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/first_cycle.h>
#include <orthocone/accuracy/step_search.h>
#include <orthocone/scene/parameters.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orthocone::test
{
namespace
{
/// Case C on few cells, whose top moves on a path that turns; the first leg is proportional.
Parameters turning()
{
  Parameters parameters;
  parameters.mesh.core_cells = parameters.mesh.rings = 2;
  parameters.mesh.layers = 2;
  parameters.mesh.degree = 1;
  parameters.friction.mu = {{0.3, 0.15}};
  parameters.friction.slip_potential = std::array<double, 2>{{0.15, 0.3}};
  parameters.load.legs = {move_to(0, 0, -0.1, 2), move_to(0.02, 0, -0.08, 2), move_to(0, 0.01, -0.05, 2)};
  return parameters;
}

Quantities marched(const Scene &scene, const LoadOptions &load)
{
  StepSolver solver(scene);
  return march_first_cycle(scene, load, solver, "test").quantities;
}

void ignore(const std::string &) {}
} // namespace

TEST(FirstOrderError, BoundsWhatConvergesAtFirstOrderOrNearlySo)
{
  for (const double ratio : {0.25, 0.5, 0.6})
  {
    const auto error = [&](const unsigned int n_halvings) { return std::pow(ratio, n_halvings); };
    for (unsigned int n = 1; n < 6; ++n)
    {
      const double change = error(n) - error(n + 1), before = error(n - 1) - error(n);
      EXPECT_GE(first_order_error(change, before), 0.999 * error(n)) << ratio;
      EXPECT_LE(first_order_error(change, before), 2 * error(n)) << ratio;
    }
  }
  EXPECT_GT(first_order_error(0, 1), 0) << "a change that is small by chance";
}

TEST(StepSearch, DividesUntilTheTrueErrorsAreAsSmallAsWanted)
{
  const Parameters parameters = turning();
  const ModelChoice choice = choose_model(parameters);
  const Scene scene(parameters, choice);
  LoadOptions finest = parameters.load;
  for (Leg &leg : finest.legs)
    leg.parts = 64;
  const Quantities truth = marched(scene, finest);
  for (const double wanted : {5., 1.})
  {
    const DividedSteps divided = find_steps(parameters, choice, wanted, ignore);
    ASSERT_TRUE(divided.accuracy.estimate.is_reached());
    EXPECT_EQ(divided.load.legs[0].parts, 1u) << "nothing errs while all is proportional";
    EXPECT_EQ(wanted<2, divided.load.legs[2].parts> 1) << "each leg as its error asks";
    EXPECT_EQ(divided.load.legs[1].steps, 2u);
    const Quantities values = marched(scene, divided.load);
    for (unsigned int i = 0; i < n_quantities; ++i)
    {
      EXPECT_EQ(values[i], divided.accuracy.estimate.values[i]) << "the given mesh is coarse enough";
      EXPECT_NEAR(values[i], truth[i], wanted / 100 * std::abs(truth[i])) << quantity_names[i];
      EXPECT_LT(divided.accuracy.solver[i], 0.01) << quantity_names[i];
    }
  }
}

/// Nothing dissipates: the area of the loop is the solver's rounding, whatever the steps. Forces drive the
/// top.
TEST(StepSearch, DoesNotChaseALoopThatIsNone)
{
  Parameters parameters = turning();
  parameters.friction.mu = {{0, 0}};
  parameters.friction.slip_potential.reset();
  parameters.load.legs = {Leg(), Leg()};
  parameters.load.legs[0].targets[2] = Drive{true, -1e5};
  parameters.load.legs[1].targets[2] = Drive{true, -1e4};
  const DividedSteps divided = find_steps(parameters, choose_model(parameters), 1, ignore);
  EXPECT_TRUE(divided.accuracy.estimate.is_reached());
}

/// A parameter file could not have more.
TEST(StepSearch, KeepsWithinTheStepsOfAProgram)
{
  Parameters parameters = turning();
  parameters.load.cycles = 50000; // of 6 steps
  const DividedSteps divided = find_steps(parameters, choose_model(parameters), 0.1, ignore);
  EXPECT_FALSE(divided.accuracy.estimate.is_reached());
  EXPECT_LE(LoadProgram(divided.load).n_solved_parts(), most_solved_parts);
  parameters.load = divided.load;
  EXPECT_NO_THROW(check_parameters(parameters));
}

TEST(StepSearch, SaysSoWhereItDoesNotReachWhatIsWanted)
{
  Parameters parameters = turning();
  parameters.load.legs[1].parts = 64;
  const DividedSteps divided = find_steps(parameters, choose_model(parameters), 1e-6, ignore);
  EXPECT_FALSE(divided.accuracy.estimate.is_reached());
  EXPECT_EQ(divided.load.legs[1].parts, 64u);
}
} // namespace orthocone::test
