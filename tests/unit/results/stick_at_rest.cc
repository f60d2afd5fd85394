// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Stick and slip where nothing moves, and where a digit more or less would put a node on the other side.
#include "results/scenes.h"

#include <algorithm>
#include <random>
#include <set>

namespace orthocone::test
{
namespace
{
std::vector<double> areas_of(const Parameters &parameters)
{
  std::vector<double> areas;
  TestScene scene(parameters);
  scene.march([&](const ContactState &, const ContactState &after, const LoadStep &)
              { areas.push_back(scene.evaluator.stick_area(after)); });
  return areas;
}

/// The numbers times 1 plus or minus `small` at random, and the differences to the largest of them.
void disturb(Eigen::VectorXd &numbers, const double small, std::mt19937 &random)
{
  std::uniform_real_distribution<double> one(-1, 1);
  const double largest = numbers.lpNorm<Eigen::Infinity>();
  for (double &number : numbers)
    number *= 1 + small * one(random);
  for (Eigen::Index i = 0; i < numbers.size(); ++i)
    if (i % 3 != 0) // tangential
      numbers[i] += small * largest * one(random);
}

/// Case B or C, pressed, held, half released, held, pushed aside, held, and released but for a little.
Parameters with_rests(const std::array<double, 2> &slip_ellipse, const std::string &gap)
{
  Parameters parameters = small_scene(2);
  parameters.mesh.model = ModelKind::half;
  parameters.contact_solver.tolerance = 1e-10;
  parameters.friction.slip_potential = slip_ellipse;
  parameters.obstacle.gap = gap;
  const double ux = 0.01;
  parameters.load.legs = {move_to(0, 0, -0.1, 2),   move_to(0, 0, -0.1, 1),   move_to(0, 0, -0.06, 2),
                          move_to(0, 0, -0.06, 1),  move_to(ux, 0, -0.06, 2), move_to(ux, 0, -0.06, 2),
                          move_to(ux, 0, -0.02, 3), move_to(ux, 0, -0.02, 1)};
  return parameters;
}
} // namespace

TEST(StickAtRest, AStepThatHoldsTheLoadChangesNothing)
{
  for (const auto &slip_ellipse : slip_ellipses)
  {
    Parameters parameters = with_rests(slip_ellipse, "0");
    std::vector<Leg> moving;
    for (unsigned int i : {0, 2, 4, 6})
      moving.push_back(parameters.load.legs[i]);
    const std::vector<double> held = areas_of(parameters);
    parameters.load.legs = moving;
    const std::vector<double> areas = areas_of(parameters);
    const std::array<unsigned int, 14> step_of{{1, 2, 2, 3, 4, 4, 5, 6, 6, 6, 7, 8, 9, 9}};
    ASSERT_EQ(held.size(), step_of.size());
    for (std::size_t i = 0; i < held.size(); ++i)
      EXPECT_NEAR(held[i], areas[step_of[i] - 1], 1e-6 * 314) << "step " << i + 1;
    EXPECT_GT(areas[5], 20);
  }
}

TEST(StickAtRest, NodesThatDoNotMoveKeepTheirStatus)
{
  TestScene scene(with_rests(slip_ellipses[1], "0"));
  scene.march(
      [&](const ContactState &before, const ContactState &after, const LoadStep &step)
      {
        const std::set<unsigned int> held{3, 6, 9, 10, 14};
        EXPECT_TRUE(held.count(step.number) == 0 || before.status == after.status) << step.number;
      });
}

/// Weights of hanging nodes may be negative, but nothing sticks at a node between others that slip.
TEST(StickAtRest, NothingSticksBetweenOpenNodes)
{
  Parameters parameters = small_scene(2);
  parameters.mesh.model = ModelKind::quarter;
  parameters.mesh.refined_cells = {{{0, 2}, {7, 9}}};
  parameters.friction.slip_potential = slip_ellipses[1];
  const std::vector<double> areas = areas_of(parameters);
  EXPECT_GT(areas[6], 50);
  EXPECT_EQ(areas.back(), 0);
}

/// Every state of the way, also those at rest: noise of 1e-10 in all forces and displacements does not show,
/// whatever it makes of the status of a node.
TEST(StickAtRest, RoundingDoesNotDecideOnTheArea)
{
  constexpr double small = 1e-10;
  std::mt19937 random(3);
  for (const std::string gap : {"0", "(x^2+y^2)/2000"})
    for (const auto &slip_ellipse : slip_ellipses)
    {
      TestScene scene(with_rests(slip_ellipse, gap));
      const auto watch = [&](const ContactState &, const ContactState &after, const LoadStep &step)
      {
        const double area = scene.evaluator.stick_area(after);
        for (unsigned int n = 0; n < 5; ++n)
        {
          ContactState other = after;
          disturb(other.force, small, random);
          disturb(other.displacement, small, random);
          EXPECT_NEAR(scene.evaluator.stick_area(other), area, 1e-8 * 314) << gap << ", " << step.number;
        }
      };
      scene.march(watch);
    }
}

/// The noise enters the march itself, as that of another number of threads does.
TEST(StickAtRest, RoundingOnTheWayDoesNotDecideOnTheArea)
{
  const Parameters parameters = with_rests(slip_ellipses[1], "0");
  const std::vector<double> expected = areas_of(parameters);
  std::mt19937 random(5);
  const Scene scene(parameters, choose_model(parameters));
  const ContactFieldEvaluator evaluator(scene);
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  for (const LoadStep &step : LoadProgram(parameters.load).steps())
  {
    const ContactState before = state;
    ASSERT_TRUE(solver.solve(state, step).converged);
    EXPECT_NEAR(evaluator.stick_area(state), expected[step.number - 1], 1e-6 * 314) << step.number;
    disturb(state.force, 1e-12, random);
    disturb(state.displacement, 1e-12, random);
    solver.accept(before, state, step);
  }
}
} // namespace orthocone::test
